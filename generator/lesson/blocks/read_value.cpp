#include "lesson/blocks/read_value.h"

#include <re2/re2.h>

#include <string>

namespace mjcourse {
namespace {

constexpr const char* kValueCure =
    "a value is written `{joint_zoo} model.nq`; for code that looks like one write "
    "`<code>…</code>`";

// The end of the name behind the brace that `code` begins with; 0 where there is none.
std::size_t end_of_name(std::string_view code) {
  static const RE2 form(R"(\{[A-Za-z_][\w.-]*(?:/[\w.-]+)*)");
  re2::StringPiece rest(code);
  RE2::Consume(&rest, form);
  return code.size() - rest.size();
}

// Where a format such as ` :.4f` begins in `code`; its end where there is none. Of `a ? b :c` only
// what is a format can be one.
std::size_t start_of_format(const std::string& code) {
  static const RE2 format(R"((\s:(?:\.\d{1,2})?[fegd])$)"), attempt(R"((\s:\S*)$)");
  const bool conditional = code.find('?') != code.npos;
  std::string found;
  RE2::PartialMatch(code, conditional ? format : attempt, &found);
  return code.size() - found.size();
}

bool is_format(const std::string& text) {
  static const RE2 form(R"(d|(\.(\d|1[0-7]))?[feg])");
  return RE2::FullMatch(text, form);
}

}  // namespace

bool is_value(std::string_view code) {
  const std::size_t name = end_of_name(code);
  if (name == 0 || name == code.size()) return false;
  const std::string_view rest = code.substr(name);
  return rest.front() == '}' ? rest.size() > 1 : rest.front() == ' ' && rest.find('}') == rest.npos;
}

std::optional<InlineValue> read_value(const LocatedText& code, Reading& reading) {
  const std::string& text = code.text;
  const std::size_t close = end_of_name(text);
  if (text[close] != '}') {
    reading.error("E-value-form", code.span(0, 1), "this `{` is never closed", kValueCure);
    return std::nullopt;
  }
  if (text[close + 1] != ' ') {
    reading.error("E-value-form", code.span(close, close + 1),
                  "a space is missing after the name in braces", kValueCure);
    return std::nullopt;
  }
  const std::size_t format = start_of_format(text);
  const std::size_t begin = text.find_first_not_of(' ', close + 1);
  if (begin >= format) {
    reading.error("E-value-form", code.span(), "no expression follows the name in braces",
                  kValueCure);
    return std::nullopt;
  }
  InlineValue value{code.part(1, close), code.part(begin, format), {}};
  if (format == text.size()) return value;
  value.format = code.part(format + 2, text.size());
  if (is_format(value.format.text)) return value;
  reading.error("E-value-format", code.span(format + 1, text.size()),
                "`:" + value.format.text + "` is not a number format",
                "write `:d`, `:.4f`, `:.3e` or `:.6g`, with up to 17 digits");
  return std::nullopt;
}

}  // namespace mjcourse
