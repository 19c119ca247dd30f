#include "report/github.h"

#include <string_view>

#include "base/percent_encoding.h"
#include "base/utf8.h"
#include "report/other_tools.h"

namespace mjcourse {
namespace {

// With what would end the message, or the property, as its number.
std::string escaped(std::string_view text, std::string_view special) {
  return percent_encoded(text, [&](char c) { return special.find(c) == special.npos; });
}

std::string property(std::string_view name, std::string_view value) {
  return std::string(name) + "=" + escaped(value, "%\r\n:,");
}

std::string annotation(const Diagnostic& diagnostic, const std::string& folder) {
  const Place& place = diagnostic.place;
  std::string line = diagnostic.severity == Severity::error ? "::error " : "::warning ";
  line += property("file", readable(course_path(folder, place.file)));
  if (place.line > 0) line += "," + property("line", std::to_string(place.line));
  if (place.column > 0) {
    line += "," + property("col", std::to_string(place.column));
    line += "," + property("endColumn", std::to_string(place.column + place.width));
  }
  line += "," + property("title", diagnostic.id);
  return line + "::" + escaped(message_with_cure(diagnostic), "%\r\n") + "\n";
}

}  // namespace

std::string github_annotations(const Diagnostics& diagnostics, const std::string& folder) {
  std::string text;
  for (const Diagnostic& diagnostic : diagnostics) text += annotation(diagnostic, folder);
  return text;
}

}  // namespace mjcourse
