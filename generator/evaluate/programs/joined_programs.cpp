#include "evaluate/programs/joined_programs.h"

#include <string_view>

#include "base/text_lines.h"

namespace mjcourse {
namespace {

constexpr std::string_view kMain = "int main(";

// A warning would cost a second compilation, without the warm header (toolchain/compiler.h), and
// nobody is told of it.
constexpr const char* kNoWarnings = R"(#ifdef __clang__
#pragma clang diagnostic ignored "-Weverything"
#endif
)";

constexpr const char* kSwitch = R"(#line 1 "joined.cpp"
inline int call(int (*version)(), int, char**) { return version(); }
inline int call(int (*version)(int, char**), int count, char** words) {
  return version(count, words);
}
int main(int count, char** words) {
  const int index = words[1][0] - 'a';
  words[1] = words[0];
)";

// So that the line behind it is the one behind `lines` lines of `path`.
std::string line_mark(std::size_t lines, const std::string& path) {
  return "#line " + std::to_string(lines + 1) + " \"" + path + "\"\n";
}

std::string name_of(std::size_t index) {
  return "version_" + std::to_string(index);
}

bool is_include(std::string_view line) {
  return trimmed(line).starts_with("#include");
}

// What may stand before the first line of code.
bool is_no_code(std::string_view line) {
  const std::string_view text = trimmed(line);
  return text.empty() || (text.starts_with("//") && !text.ends_with('\\')) || is_include(line);
}

// The number of lines up to the last of the leading includes.
std::size_t include_lines(const std::vector<std::string_view>& lines) {
  std::size_t behind = 0;
  for (std::size_t i = 0; i < lines.size() && is_no_code(lines[i]); ++i) {
    if (is_include(lines[i])) behind = i + 1;
  }
  return behind;
}

std::string joined_lines(const std::vector<std::string_view>& lines, std::size_t begin,
                         std::size_t end) {
  std::string text;
  for (std::size_t i = begin; i < end; ++i) text.append(lines[i]).append("\n");
  return text;
}

// The lines behind the includes, with main() as a function that returns 0 at its end; nothing where
// that is not found, or the compiler is told more than where a line is from.
std::optional<std::string> body_of(const std::vector<std::string_view>& lines, std::size_t begin,
                                   const std::string& marks) {
  enum { before, inside, behind } place = before;
  bool is_strangers = false;
  std::string text;
  for (std::size_t i = begin; i < lines.size(); ++i) {
    const std::string_view line = lines[i];
    const std::string_view words = trimmed(line);
    const bool is_mark = !marks.empty() && line.ends_with(" \"" + marks + "\"");
    if (is_mark) is_strangers = !is_strangers;
    if (is_mark || is_strangers || words.starts_with("#line ")) {
      text.append(line).append("\n");
      continue;
    }
    if (words.starts_with('#')) return std::nullopt;
    if (place == inside && words.starts_with("// #region ")) return std::nullopt;
    if (line.starts_with(kMain)) {
      if (place != before || line.ends_with('}')) return std::nullopt;
      place = inside;
      text.append("int main_of_version(").append(line.substr(kMain.size()));
    } else if (place == inside && line == "}") {
      place = behind;
      text += "return 0; }";
    } else {
      text.append(line);
    }
    text += '\n';
  }
  return place == behind ? std::optional(std::move(text)) : std::nullopt;
}

}  // namespace

std::optional<std::string> joined_programs(const std::vector<Version>& versions,
                                           const std::string& path, const std::string& shared,
                                           const std::string& at_end) {
  std::string includes, bodies, choice;
  for (std::size_t i = 0; i < versions.size(); ++i) {
    const std::vector<std::string_view> lines = lines_of(versions[i].text);
    const std::size_t begin = include_lines(lines);
    const std::string own = joined_lines(lines, 0, begin);
    if (i == 0) includes = own;
    const std::optional<std::string> body = body_of(lines, begin, versions[i].marks);
    if (!body || own != includes) return std::nullopt;
    bodies += versions[i].before + "namespace " + name_of(i) + " {\n" + line_mark(begin, path) +
              *body + "}\n";
    choice += "  if (index == " + std::to_string(i) + ") return " + at_end + "(call(" + name_of(i) +
              "::main_of_version, count - 1, words + 1));\n";
  }
  // Of one alone, `::name` names its own things, as in the program.
  const std::string names =
      versions.size() == 1 ? "namespace version_0 {}\nusing namespace version_0;\n" : "";
  return includes + kNoWarnings + shared + names + bodies + kSwitch + choice + "  return 1;\n}\n";
}

std::string with_behind_includes(const std::string& program, const std::string& inserted,
                                 const std::string& path) {
  const std::vector<std::string_view> lines = lines_of(program);
  const std::size_t begin = include_lines(lines);
  return joined_lines(lines, 0, begin) + kNoWarnings + inserted + line_mark(begin, path) +
         joined_lines(lines, begin, lines.size());
}

std::vector<std::string> joined_arguments(std::size_t index, std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), std::string(1, static_cast<char>('a' + index)));
  return arguments;
}

}  // namespace mjcourse
