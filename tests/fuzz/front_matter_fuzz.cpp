// A lesson whose front matter is any text, between its lines.
#include "fuzz.h"
#include "lesson_check.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string yaml = mjcourse::text_of_input(data, size);
  mjcourse::check_reading("content/1-a/1.1-x.md", "---\n" + yaml + "\n---\n\nA *lesson*.\n");
  return 0;
}
