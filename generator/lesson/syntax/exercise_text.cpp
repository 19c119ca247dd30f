#include "lesson/syntax/exercise_text.h"

#include <re2/re2.h>

#include <algorithm>
#include <array>
#include <utility>

#include "base/nearest.h"
#include "base/text_lines.h"

namespace mjcourse {
namespace {

constexpr std::string_view kMark = "// #";
// Behind `// #`, of lines of code that a variant has.
constexpr std::array<std::string_view, 11> kDirectives{"include", "define", "undef",  "if",
                                                       "ifdef",   "ifndef", "elif",   "else",
                                                       "endif",   "pragma", "warning"};

struct Mark {
  std::string word, rest;  // "wrong", "forgets-g: the weight"
};

// Nothing where the line is code, or a comment.
std::optional<Mark> mark_in(std::string_view line) {
  line = trimmed(line);
  if (!line.starts_with(kMark)) return std::nullopt;
  line.remove_prefix(kMark.size());
  const std::size_t end = std::min(line.find(' '), line.size());
  const std::string_view word = line.substr(0, end);
  if (word.empty() || std::ranges::count(kDirectives, word) > 0) return std::nullopt;
  return Mark{std::string(word), std::string(trimmed(line.substr(end)))};
}

bool opens(std::string_view line, std::string_view region) {
  const auto mark = mark_in(line);
  return mark && mark->word == "region" && mark->rest == region;
}

// The first line from `at` on that is no mark, and is written as editors, formatters and people
// write one: `//#region answer`, `#pragma region answer`. In words; "" where there is none.
std::string almost(const std::vector<std::string_view>& lines, std::size_t at,
                   const std::string& word, const std::string& region) {
  const RE2 form(R"((?i)(?:/[/*]+\s*#?|#)\s*(?:pragma\s+)?)" + word + R"(\b\s*(.*))");
  for (; at < lines.size(); ++at) {
    const auto mark = mark_in(lines[at]);
    std::string rest;
    if ((mark && mark->word == word) || !RE2::FullMatch(trimmed(lines[at]), form, &rest)) continue;
    if (!rest.starts_with(region)) continue;
    return ": write line " + std::to_string(at + 1) + " as `// #" + word +
           (region.empty() ? "" : " " + region) + "`";
  }
  return "";
}

bool begins_variant(const Mark& mark) {
  return mark.word == "starter" || mark.word == "wrong";
}

// The line without its comment sign: `put` in its place. Nothing where it has none.
std::optional<std::string> uncommented(std::string_view line, std::string_view put) {
  const std::size_t at = line.find_first_not_of(" \t");
  if (at == line.npos) return "";
  if (line.substr(at, 2) != "//") return std::nullopt;
  std::string_view code = line.substr(at + 2);
  if (code.starts_with(' ')) code.remove_prefix(1);
  if (trimmed(code).empty()) return "";
  return std::string(line.substr(0, at)).append(put).append(code);
}

Diagnostic fault(const SourceText& file, int line, std::string message, std::string cure) {
  const std::size_t begin = file.line_start(line);
  const std::string_view text = file.line(line);
  const std::size_t indentation = std::min(text.find_first_not_of(" \t"), text.size());
  return error_at(
      place_of(file, {begin + indentation, begin + std::max(text.size(), indentation + 1)}),
      "E-exercise-text", std::move(message), std::move(cure));
}

std::string joined_lines(const SourceText& file, int begin, int end) {
  std::string text;
  for (int line = begin; line < end; ++line) text.append(file.line(line)).append("\n");
  return text;
}

// `lines`, of which each ends; a SourceText counts an empty one behind the end of its last.
std::string with_the_end_of(std::string_view file, std::string lines) {
  if (file.ends_with('\n')) lines.pop_back();
  return lines;
}

// "NAME: CHECK" behind `// #wrong`.
bool read_wrong(const std::string& words, ExerciseText::Variant& variant) {
  static const RE2 form(R"(([A-Za-z0-9_-]+):\s+(\S.*))");
  return RE2::FullMatch(words, form, &variant.name, &variant.check);
}

}  // namespace

std::string ExerciseText::program(std::string_view code) const {
  std::string text;
  for (int line = 1; line <= file_.line_count(); ++line) {
    if (line > begin_ && line < end_) continue;
    const auto mark = mark_in(file_.line(line));
    const bool is_own = line == begin_ || line == end_;
    if (mark && !is_own && mark->word.ends_with("region")) continue;
    text.append(file_.line(line)).append("\n");
    if (line == begin_) text += code;
  }
  return with_the_end_of(file_.text(), std::move(text));
}

std::size_t ExerciseText::code_begin() const {
  const std::string without = program("");
  const SourceText text(file_.path(), without);
  for (int line = 1; line <= text.line_count(); ++line) {
    if (text.line(line) == file_.line(begin_)) return text.line_start(line + 1);
  }
  return without.size();
}

int ExerciseText::code_line() const {
  return SourceText(file_.path(), program("")).position(code_begin()).line;
}

std::string ExerciseText::numbered_program(std::string_view code) const {
  const std::string without = program("");
  const std::size_t begin = code_begin();
  return without.substr(0, begin).append(code) + "#line " + std::to_string(end_) + " \"" +
         file_.path() + "\"\n" + without.substr(begin);
}

std::string ExerciseText::in_place(const Variant& variant) const {
  std::string text;
  for (int line = 1; line <= file_.line_count(); ++line) {
    std::string_view as_it_is = file_.line(line);
    if (line > begin_ && line < solution_end_) {
      as_it_is = "";
    } else if (line > variant.mark && line < variant.end) {
      text += uncommented(as_it_is, "   ").value_or("") + "\n";
      continue;
    }
    text.append(as_it_is).append("\n");
  }
  return with_the_end_of(file_.text(), std::move(text));
}

// Reads the one region; each step gives false (reported) where no more can be understood.
class ExerciseReader {
 public:
  ExerciseReader(const SourceText& file, Diagnostics& diagnostics)
      : diagnostics_(diagnostics), exercise_(file) {}

  std::optional<ExerciseText> read(const std::string& region) {
    const std::size_t faults = diagnostics_.size();
    const bool understood = find_begin(region) && read_lines() && check_parts();
    if (!understood || diagnostics_.size() > faults) return std::nullopt;
    return std::move(exercise_);
  }

 private:
  bool find_begin(const std::string& region) {
    const SourceText& file = exercise_.file_;
    int line = 1;
    std::vector<std::string> known;
    for (; line <= file.line_count() && !opens(file.line(line), region); ++line) {
      const auto mark = mark_in(file.line(line));
      if (mark && mark->word == "region") known.push_back(mark->rest);
    }
    exercise_.begin_ = line;
    return line <= file.line_count() ||
           fail(1, "the program has no region `" + region + "`",
                known.empty()
                    ? "put the solution between `// #region " + region + "` and `// #endregion`"
                    : suggest(region, known));
  }

  bool read_lines() {
    const SourceText& file = exercise_.file_;
    for (int line = exercise_.begin_ + 1; line <= file.line_count(); ++line) {
      const auto mark = mark_in(file.line(line));
      if (!mark) continue;
      if (exercise_.solution_end_ == 0) exercise_.solution_end_ = line;
      close_variant(line);
      if (mark->word == "endregion") {
        exercise_.end_ = line;
        return true;
      }
      if (!open_variant(*mark, line)) return false;
    }
    return fail(exercise_.begin_, "the region is never closed",
                "end it with a line `// #endregion`");
  }

  bool open_variant(const Mark& mark, int line) {
    if (!begins_variant(mark)) {
      return fail(line, "a region that is an exercise has no mark `#" + mark.word + "`",
                  mark.word == "region" ? "an exercise is one region: end it before the next begins"
                                        : suggest(mark.word, {"starter", "wrong", "endregion"}));
    }
    open_.emplace().mark = line;
    return mark.word == "starter" || read_wrong(mark.rest, *open_) ||
           fail(line, "a mistake has a name, and the check that is to refuse it",
                "write `// #wrong NAME: CHECK`, with what the check says of itself");
  }

  // The variant that was open ends before `line`.
  void close_variant(int line) {
    if (!open_) return;
    ExerciseText::Variant variant = *std::exchange(open_, std::nullopt);
    variant.end = line;
    for (int at = variant.mark + 1; at < line; ++at) {
      const auto code = uncommented(exercise_.file_.line(at), "");
      if (!code) {
        fail(at, "this line stands behind the solution and is no comment",
             "put `// ` in front of it: the file itself compiles with the solution");
        break;
      }
      variant.code += *code + "\n";
    }
    std::vector<ExerciseText::Variant>& known = exercise_.variants_;
    if (std::ranges::count(known, variant.name, &ExerciseText::Variant::name) == 0) {
      known.push_back(std::move(variant));
    } else if (variant.name.empty()) {
      fail(variant.mark, "this region has two starters", "remove one of them");
    } else {
      fail(variant.mark, "there are two mistakes `" + variant.name + "`",
           "give each a name of its own");
    }
  }

  bool check_parts() {
    exercise_.solution_ =
        joined_lines(exercise_.file_, exercise_.begin_ + 1, exercise_.solution_end_);
    if (trimmed(exercise_.solution_).empty()) {
      fail(exercise_.begin_, "the region has no solution",
           "write it as code, before `// #starter`");
    }
    static const RE2 checks(R"(\bexpect(?:_near|_alike)?\s*\()");
    if (RE2::PartialMatch(exercise_.solution_, checks)) {
      fail(exercise_.begin_, "the solution makes a check, which nobody else would make",
           "make the checks outside of the region");
    }
    std::vector<ExerciseText::Variant>& all = exercise_.variants_;
    const auto starter = std::ranges::find(all, "", &ExerciseText::Variant::name);
    if (starter == all.end()) {
      return fail(exercise_.begin_, "the region has no starter, with which its reader would begin",
                  "write it behind the solution, in comments, below a line `// #starter`");
    }
    std::rotate(all.begin(), starter, starter + 1);
    return true;
  }

  // Gives false.
  bool fail(int line, std::string message, std::string cure) {
    diagnostics_.push_back(fault(exercise_.file_, line, std::move(message), std::move(cure)));
    return false;
  }

  Diagnostics& diagnostics_;
  ExerciseText exercise_;
  std::optional<ExerciseText::Variant> open_;
};

std::optional<ExerciseText> read_exercise(const SourceText& file, const std::string& region,
                                          Diagnostics& diagnostics) {
  return ExerciseReader(file, diagnostics).read(region);
}

bool begins_variant(std::string_view line) {
  const auto mark = mark_in(line);
  return mark && begins_variant(*mark);
}

tl::expected<std::string, std::string> code_in_region(std::string_view program,
                                                      std::string_view region) {
  const std::vector<std::string_view> lines = lines_of(program);
  const std::string name = "region `" + std::string(region) + "`";
  std::vector<std::size_t> begins;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (opens(lines[i], region)) begins.push_back(i);
  }
  if (begins.empty()) {
    return tl::unexpected("has no " + name + almost(lines, 0, "region", std::string(region)));
  }
  if (begins.size() > 1) {
    return tl::unexpected("has the " + name + " twice, from lines " +
                          std::to_string(begins[0] + 1) + " and " + std::to_string(begins[1] + 1) +
                          " on: remove one of them");
  }
  std::string code;
  int depth = 1;  // a text may fold parts of its own
  for (std::size_t i = begins[0] + 1; i < lines.size(); ++i) {
    const auto mark = mark_in(lines[i]);
    if (mark && mark->word == "region") ++depth;
    if (mark && mark->word == "endregion" && --depth == 0) return code;
    code.append(lines[i]).append("\n");
  }
  return tl::unexpected("has no end of the " + name +
                        almost(lines, begins[0] + 1, "endregion", ""));
}

std::optional<std::string> with_code_in_region(std::string_view program, std::string_view region,
                                               std::string_view code, const std::string& path) {
  std::string text;
  int number = 0;
  bool inside = false, found = false;
  for (const std::string_view line : lines_of(program)) {
    ++number;
    const auto mark = mark_in(line);
    if (inside && mark && mark->word == "endregion") {
      inside = false;
      found = true;
      text += "#line " + std::to_string(number) + " \"" + path + "\"\n";
    }
    if (inside) continue;
    text.append(line).append("\n");
    if (found || !opens(line, region)) continue;
    inside = true;
    text.append("#line " + std::to_string(kCodeLine) + " \"" + path + "\"\n").append(code);
  }
  return found ? std::optional(std::move(text)) : std::nullopt;
}

std::string without_exercise(std::string_view program) {
  if (program.find("// #starter") == program.npos && program.find("// #wrong") == program.npos) {
    return std::string(program);
  }
  std::string text;
  bool is_solution = true;
  for (const std::string_view line : lines_of(program)) {
    if (const auto mark = mark_in(line)) {
      if (begins_variant(*mark)) is_solution = false;
      if (mark->word == "endregion") is_solution = true;
    }
    if (is_solution) text.append(line).append("\n");
  }
  return text;
}

}  // namespace mjcourse
