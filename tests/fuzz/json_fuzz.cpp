// A fence of any JSON. The input's first line is the fence's ("lab simlab", "quiz", "figure",
// "plot"), the rest its body.
#include <algorithm>

#include "fuzz.h"
#include "lesson_check.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string input = mjcourse::text_of_input(data, size);
  const std::string fence(20, '`');  // longer than any that a body is likely to have
  const std::string end = input.ends_with('\n') ? "" : "\n";
  mjcourse::check_reading("content/1-a/1.1-x.md",
                          "---\ntitle: T\n---\n\n" + fence + input + end + fence + "\n");
  return 0;
}
