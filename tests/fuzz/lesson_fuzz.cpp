// A lesson of any bytes.
#include "fuzz.h"
#include "lesson_check.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  mjcourse::check_reading("content/1-a/1.1-x.md", mjcourse::text_of_input(data, size));
  return 0;
}
