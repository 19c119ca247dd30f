#include "physics/mistakes/model_error.h"

#include <mujoco/mujoco.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <filesystem>
#include <optional>
#include <sstream>
#include <string_view>
#include <utility>
#include <vector>

#include "base/nearest.h"
#include "physics/mistakes/mjcf_schema.h"
#include "physics/mistakes/newer_mjcf.h"

namespace mjcourse {
namespace {

std::string on_one_line(const std::string& text) {
  std::istringstream words(text);
  std::string line;
  for (std::string word; words >> word;) line += (line.empty() ? "" : " ") + word;
  return line;
}

constexpr std::string_view kBlanks = " \t\r\n";

// Reads a text from its front on. (Whatever an author wrote may stand in it, of any length: a
// regular expression would go down into that.)
class Scanner {
 public:
  explicit Scanner(std::string_view text) : rest_(text) {}

  std::string_view rest() const { return rest_; }

  // Whether `word` stood here; then it is passed.
  bool take(std::string_view word) {
    if (!rest_.starts_with(word)) return false;
    rest_.remove_prefix(word.size());
    return true;
  }

  // What stands before `stop`, which is passed too; nothing where that does not come.
  std::optional<std::string> take_before(std::string_view stop) {
    const std::size_t end = rest_.find(stop);
    if (end == rest_.npos) return std::nullopt;
    std::string text(rest_.substr(0, end));
    rest_.remove_prefix(end + stop.size());
    return text;
  }

  void skip_blanks() {
    rest_.remove_prefix(std::min(rest_.find_first_not_of(kBlanks), rest_.size()));
  }

  // MuJoCo writes 0 or -1 for a line or a column that it does not know: 0.
  int take_number() {
    int number = 0;
    const auto end = std::from_chars(rest_.data(), rest_.data() + rest_.size(), number).ptr;
    rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
    return std::max(0, number);
  }

 private:
  std::string_view rest_;
};

// "XML_ERROR_MISMATCHED_ELEMENT" with its detail "XMLElement name=geom", in words.
std::string xml_problem(std::string kind, std::string_view detail) {
  if (kind == "FILE_NOT_FOUND") return "file not found";
  if (kind == "EMPTY_DOCUMENT") return "the file is empty";
  std::replace(kind.begin(), kind.end(), '_', ' ');
  for (char& c : kind) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  std::string where = on_one_line(std::string(detail));
  constexpr std::string_view kElement = "XMLElement name=";
  if (const std::size_t at = where.find(kElement); at != where.npos) {
    const std::size_t name = at + kElement.size();
    const std::size_t end = std::min(where.find(' ', name), where.size());
    where = where.substr(0, at) + "'" + where.substr(name, end - name) + "'" + where.substr(end);
  }
  return "not well-formed XML: " + kind + (where.empty() ? "" : " " + where);
}

// The value of the attribute `file` in the tag whose attributes `tag` begins with; "" for none.
std::string file_in(std::string_view tag) {
  tag = tag.substr(0, tag.find('>'));
  for (std::size_t at = 0; (at = tag.find("file", at)) != tag.npos;) {
    Scanner scanner(tag.substr(at += 4));
    scanner.skip_blanks();
    if (!scanner.take("=")) continue;
    scanner.skip_blanks();
    for (const std::string_view quote : {"\"", "'"}) {
      if (scanner.take(quote)) return scanner.take_before(quote).value_or("");
    }
  }
  return "";
}

// The `file` of the <include> that begins on line `line` of `mjcf`; "" when there is none.
std::string included_file(std::string_view mjcf, int line) {
  if (line <= 0) return "";
  Scanner lines(mjcf);
  for (int i = 1; i < line; ++i) {
    if (!lines.take_before("\n")) return "";
  }
  return lines.take_before("<include") ? file_in(lines.rest()) : "";
}

// XML parse error 14:
// Error=XML_ERROR_MISMATCHED_ELEMENT ErrorID=14 (0xe) Line number=3: XMLElement name=geom
std::optional<ModelError> parse_error(std::string_view answer, const std::string& file) {
  Scanner scanner(answer);
  if (!scanner.take("XML parse error ") || !scanner.take_before("Error=XML_ERROR_")) {
    return std::nullopt;
  }
  const auto kind = scanner.take_before(" ErrorID=");
  if (!kind || !scanner.take_before(" Line number=")) return std::nullopt;
  const int line = scanner.take_number();
  scanner.take(":");
  return ModelError{file, line, 0, xml_problem(*kind, scanner.rest())};
}

std::string suggest_or_date(const std::string& word, const std::string& since,
                            const std::vector<std::string>& known) {
  if (!since.empty()) {
    return "MuJoCo has `" + word + "` from version " + since + " on; this is MuJoCo " +
           mj_versionString();
  }
  const std::string near = nearest(word, known);
  return near.empty() ? "" : "did you mean `" + near + "`?";
}

// What to write in place of a word that MuJoCo does not know, or which MuJoCo knows it.
std::string cure_for(const std::string& message, const std::string& element) {
  Scanner scanner(message);
  if (message == "unrecognized element") {
    return suggest_or_date(element, since_when_element(element), mjcf_elements());
  }
  if (scanner.take("unrecognized attribute: '")) {
    const std::string name = scanner.take_before("'").value_or("");
    return suggest_or_date(name, since_when_attribute(element, name), mjcf_attributes(element));
  }
  if (scanner.take("invalid keyword: '")) {
    const std::string word = scanner.take_before("'").value_or("");
    return suggest_or_date(word, since_when_keyword(element, word), {});
  }
  return "";
}

// Cuts `text` in two at the last `mark`: MuJoCo's own words come behind an author's.
std::optional<std::pair<std::string_view, std::string_view>> cut_at_last(std::string_view text,
                                                                         std::string_view mark) {
  const std::size_t at = text.rfind(mark);
  if (at == text.npos) return std::nullopt;
  return std::pair(text.substr(0, at), text.substr(at + mark.size()));
}

// XML Error: Schema violation: unrecognized attribute: 'sizee'
//
// Element 'geom', line 5, column 3
std::optional<ModelError> element_error(std::string_view answer, const std::string& file) {
  Scanner scanner(answer);
  if (!scanner.take("XML Error: ")) return std::nullopt;
  scanner.take("Schema violation: ");
  const auto parts = cut_at_last(scanner.rest(), "\nElement '");
  const auto named = parts ? cut_at_last(parts->second, "', line ") : std::nullopt;
  if (!named) return std::nullopt;
  const std::string message = on_one_line(std::string(parts->first));
  const std::string element(named->first);
  Scanner place(named->second);
  const int line = place.take_number();
  const int column = place.take(", column ") ? place.take_number() : 0;
  return ModelError{file, line, column, "element '" + element + "': " + message,
                    cure_for(message, element)};
}

// Error: mass and inertia of moving bodies must be larger than mjMINVAL
// Object name = b, id = 1, line = 3, column = -1
std::optional<ModelError> object_error(std::string_view answer, const std::string& file) {
  Scanner scanner(answer);
  if (!scanner.take("Error: ")) return std::nullopt;
  const auto parts = cut_at_last(scanner.rest(), "\nObject name = ");
  const auto named = parts ? cut_at_last(parts->second, ", id = ") : std::nullopt;
  if (!named) return std::nullopt;
  const std::string name = on_one_line(std::string(named->first));
  Scanner place(named->second);
  int line = 0, column = 0;
  if (place.take_before(", line = ")) line = place.take_number();
  if (place.take(", column = ")) column = place.take_number();
  return ModelError{
      file, line, column,
      (name.empty() ? "" : "object '" + name + "': ") + on_one_line(std::string(parts->first))};
}

// XML Error: Include error: '(a parse error of the included file)'
// Element 'include', line 2
std::optional<ModelError> include_error(std::string_view answer, const std::string& file,
                                        std::string_view mjcf) {
  Scanner scanner(answer);
  if (!scanner.take("XML Error: Include error: '")) return std::nullopt;
  const auto parts = cut_at_last(scanner.rest(), "\nElement 'include', line ");
  if (!parts) return std::nullopt;
  const int line = Scanner(parts->second).take_number();
  const std::string name = included_file(mjcf, line);
  const std::string path = (std::filesystem::path(file).parent_path() / name).string();
  const std::string_view said = parts->first.substr(0, parts->first.rfind('\''));
  const std::optional<ModelError> inner = parse_error(said, path);
  if (!inner) return std::nullopt;
  if (inner->line > 0 && !name.empty()) return *inner;
  const std::string which = name.empty() ? "an included file" : "included file '" + name + "'";
  return ModelError{file, line, 0, which + ": " + inner->message};
}

// Whatever else MuJoCo says, which then has no line.
ModelError other_error(std::string_view answer, const std::string& file) {
  Scanner scanner(answer);
  if (scanner.take("XML Error: ") || scanner.take("Error: ")) scanner.take("engine error: ");
  return {file, 0, 0, on_one_line(std::string(scanner.rest()))};
}

ModelError error_in(const std::string& answer, const std::string& file, const std::string& mjcf) {
  if (const auto error = include_error(answer, file, mjcf)) return *error;
  if (const auto error = parse_error(answer, file)) return *error;
  if (const auto error = element_error(answer, file)) return *error;
  if (const auto error = object_error(answer, file)) return *error;
  return other_error(answer, file);
}

}  // namespace

ModelError explain_load_error(const std::string& answer, const std::string& file,
                              const std::string& mjcf) {
  ModelError error = error_in(answer, file, mjcf);
  error.message = on_one_line(error.message);  // whatever names it has in it
  return error;
}

}  // namespace mjcourse
