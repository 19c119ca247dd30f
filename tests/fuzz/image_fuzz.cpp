// A picture's file of any bytes: how large it is, and what a drawing may not hold. The input's
// first line is the file's name.
#include <algorithm>

#include "evaluate/scenes/image_size.h"
#include "evaluate/scenes/svg_faults.h"
#include "fuzz.h"
#include "require.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string input = mjcourse::text_of_input(data, size);
  const std::size_t end = std::min(input.find('\n'), input.size());
  const std::string bytes = input.substr(std::min(end + 1, input.size()));
  for (const auto& fault : mjcourse::faults_of_svg(bytes)) {
    const bool is_there = fault.span.begin <= bytes.size() && fault.span.begin < fault.span.end;
    mjcourse::require(is_there, "a mistake of a drawing is at a place of it");
  }
  const auto found = mjcourse::image_size(input.substr(0, end), bytes);
  mjcourse::require(found || !found.error().empty(), "what is no picture is said to be none");
  if (!found) return 0;
  const bool sensible =
      found->width >= 1 && found->height >= 1 && found->width <= 100000 && found->height <= 100000;
  mjcourse::require(sensible, "a picture has a size");
  return 0;
}
