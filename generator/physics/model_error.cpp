#include "physics/model_error.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <optional>
#include <regex>
#include <sstream>

#include "base/nearest.h"
#include "physics/mjcf_schema.h"

namespace mjcourse {
namespace {

std::string on_one_line(const std::string& text) {
  std::istringstream words(text);
  std::string line;
  for (std::string word; words >> word;) line += (line.empty() ? "" : " ") + word;
  return line;
}

// MuJoCo writes 0 or -1 for a line or a column that it does not know.
int number(const std::ssub_match& digits) {
  return digits.matched ? std::max(0, std::atoi(digits.str().c_str())) : 0;
}

// "XML_ERROR_MISMATCHED_ELEMENT" with its detail "XMLElement name=geom", in words.
std::string xml_problem(std::string kind, const std::string& detail) {
  if (kind == "FILE_NOT_FOUND") return "file not found";
  if (kind == "EMPTY_DOCUMENT") return "the file is empty";
  std::replace(kind.begin(), kind.end(), '_', ' ');
  for (char& c : kind) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  static const std::regex element(R"(XMLElement name=(\S+))");
  const std::string where = on_one_line(std::regex_replace(detail, element, "'$1'"));
  return "not well-formed XML: " + kind + (where.empty() ? "" : " " + where);
}

// The `file` of the <include> that begins on line `line` of `mjcf`; "" when there is none.
std::string included_file(const std::string& mjcf, int line) {
  std::size_t start = line > 0 ? 0 : std::string::npos;
  for (int i = 1; i < line && start != std::string::npos; ++i) {
    start = mjcf.find('\n', start);
    if (start != std::string::npos) ++start;
  }
  if (start == std::string::npos) return "";
  static const std::regex include(R"rx(<include\s[^>]*?file\s*=\s*["']([^"']*)["'])rx");
  std::smatch found;
  return std::regex_search(mjcf.begin() + static_cast<std::ptrdiff_t>(start), mjcf.end(), found,
                           include)
             ? found[1].str()
             : "";
}

// XML parse error 14:
// Error=XML_ERROR_MISMATCHED_ELEMENT ErrorID=14 (0xe) Line number=3: XMLElement name=geom
std::optional<ModelError> parse_error(const std::string& answer, const std::string& file) {
  static const std::regex shape(
      R"(^XML parse error \d+:\s*Error=XML_ERROR_(\w+) ErrorID=\S+ \S+ Line number=(\d+):?([^]*))");
  std::smatch found;
  if (!std::regex_match(answer, found, shape)) return std::nullopt;
  return ModelError{file, number(found[2]), 0, xml_problem(found[1], found[3])};
}

// What to write in place of a word that MuJoCo does not know.
std::string cure_for(const std::string& message, const std::string& element) {
  std::string near;
  static const std::regex attribute("unrecognized attribute: '([^']*)'");
  std::smatch found;
  if (message == "unrecognized element") {
    near = nearest(element, mjcf_elements());
  } else if (std::regex_match(message, found, attribute)) {
    near = nearest(found[1].str(), mjcf_attributes(element));
  }
  return near.empty() ? "" : "did you mean `" + near + "`?";
}

// XML Error: Schema violation: unrecognized attribute: 'sizee'
//
// Element 'geom', line 5, column 3
std::optional<ModelError> element_error(const std::string& answer, const std::string& file) {
  static const std::regex shape(
      R"(^XML Error: (?:Schema violation: )?([^]*?)\s*\nElement '([^']*)', line (-?\d+))"
      R"((?:, column (-?\d+))?\s*)");
  std::smatch found;
  if (!std::regex_match(answer, found, shape)) return std::nullopt;
  const std::string message = on_one_line(found[1]);
  const std::string element = found[2];
  return ModelError{file, number(found[3]), number(found[4]),
                    "element '" + element + "': " + message, cure_for(message, element)};
}

// Error: mass and inertia of moving bodies must be larger than mjMINVAL
// Object name = b, id = 1, line = 3, column = -1
std::optional<ModelError> object_error(const std::string& answer, const std::string& file) {
  static const std::regex shape(R"(^Error: ([^]*?)\nObject name = ([^]*?), id = -?\d+)"
                                R"((?:, line = (-?\d+), column = (-?\d+))?\s*)");
  std::smatch found;
  if (!std::regex_match(answer, found, shape)) return std::nullopt;
  const std::string name = on_one_line(found[2]);
  return ModelError{file, number(found[3]), number(found[4]),
                    (name.empty() ? "" : "object '" + name + "': ") + on_one_line(found[1])};
}

// XML Error: Include error: '(a parse error of the included file)'
// Element 'include', line 2
std::optional<ModelError> include_error(const std::string& answer, const std::string& file,
                                        const std::string& mjcf) {
  static const std::regex shape(
      R"(^XML Error: Include error: '([^]*?)'\s*\nElement 'include', line (-?\d+)[^]*)");
  std::smatch found;
  if (!std::regex_match(answer, found, shape)) return std::nullopt;
  const int line = number(found[2]);
  const std::string name = included_file(mjcf, line);
  const std::string path = (std::filesystem::path(file).parent_path() / name).string();
  const std::optional<ModelError> inner = parse_error(found[1], path);
  if (!inner) return std::nullopt;
  if (inner->line > 0 && !name.empty()) return *inner;
  const std::string which = name.empty() ? "an included file" : "included file '" + name + "'";
  return ModelError{file, line, 0, which + ": " + inner->message};
}

// Whatever else MuJoCo says, which then has no line.
ModelError other_error(const std::string& answer, const std::string& file) {
  static const std::regex preamble(R"(^(XML )?Error: (engine error: )?)");
  return {file, 0, 0, on_one_line(std::regex_replace(answer, preamble, ""))};
}

}  // namespace

ModelError explain_load_error(const std::string& answer, const std::string& file,
                              const std::string& mjcf) {
  if (const auto error = include_error(answer, file, mjcf)) return *error;
  if (const auto error = parse_error(answer, file)) return *error;
  auto error = element_error(answer, file);
  if (!error) error = object_error(answer, file);
  if (!error) return other_error(answer, file);
  // MuJoCo keeps no line of an element that came from an include.
  if (error->line == 0 && mjcf.find("<include") != std::string::npos) {
    error->message += " (in a file that this one includes)";
  }
  return *error;
}

}  // namespace mjcourse
