// A code span of any text, read as a value.
#include "base/utf8.h"
#include "diagnostic_check.h"
#include "fuzz.h"
#include "lesson/blocks/read_value.h"
#include "require.h"

namespace mjcourse {
namespace {

void check_part(const LocatedText& part, const std::string& code) {
  const Span span = part.span();
  require(span.begin <= span.end && span.end <= code.size(), "a part is in the code");
  require(code.compare(span.begin, span.end - span.begin, part.text) == 0, "it is what it says");
}

void check_value(const std::string& code) {
  // What no lesson has in one line of it.
  if (find_invalid_utf8(code) || find_control_character(code + " ") ||
      code.find('\n') != code.npos) {
    return;
  }
  if (!is_value(code)) return;
  const SourceText source("content/1-a/1.1-x.md", code);
  Diagnostics diagnostics;
  Reading reading(source, diagnostics);
  const auto value = read_value(located(source, {0, code.size()}), reading);
  check_diagnostics(diagnostics, {{source.path(), source}});
  require(value.has_value() == diagnostics.empty(), "a value, or what is wrong with it");
  if (!value) return;
  require(!value->source.text.empty() && !value->expression.text.empty(),
          "a value is of something");
  require(value->source.text.find_first_of("{} ") == std::string::npos, "a name is one word");
  for (const LocatedText* part : {&value->source, &value->expression}) check_part(*part, code);
  if (!value->format.text.empty()) check_part(value->format, code);
}

}  // namespace
}  // namespace mjcourse

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  mjcourse::check_value(mjcourse::text_of_input(data, size));
  return 0;
}
