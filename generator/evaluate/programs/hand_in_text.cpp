#include "evaluate/programs/hand_in_text.h"

#include <re2/re2.h>

#include <optional>
#include <string_view>
#include <vector>

namespace mjcourse {
namespace {

// What a region has no use for, and what could report checks in the program's place.
constexpr const char* kForging =
    R"(\b(expect|expect_near|add_check|checks|Checks|record|main|getenv|secure_getenv|environ|)"
    R"(asm|__asm|__asm__|__LINE__|__builtin_LINE|source_location|__builtin_source_location|)"
    R"(namespace|fork|vfork|execve|ptrace|syscall|MJCOURSE_\w*)\b)";

// The text as the compiler takes it: a line that ends with a backslash goes on in the next; without
// numbers, in which a quote may stand, comments, and what stands between quotes.
std::string code_alone(std::string code) {
  RE2::GlobalReplace(&code, R"(\\[ \t\r]*\n)", "");
  static const RE2 words(R"((\b[0-9][\w.']*|//[^\n]*|/\*(?s:.*?)\*/|)"
                         R"("(?:[^"\\\n]|\\.)*"|'(?:[^'\\\n]|\\.)*'))");
  RE2::GlobalReplace(&code, words, " ");
  static const RE2 opening("<%"), closing("%>"), using_all(R"(\busing\s+namespace\b)");
  RE2::GlobalReplace(&code, opening, "{");
  RE2::GlobalReplace(&code, closing, "}");
  RE2::GlobalReplace(&code, using_all, " ");
  return code;
}

bool has_word(const std::string& code, const std::string& word) {
  return RE2::PartialMatch(code, "\\b" + RE2::QuoteMeta(word) + "\\b");
}

// How many more braces it opens than it closes; nothing where it closes one that it did not open.
std::optional<int> depth_of(std::string_view code) {
  int depth = 0;
  for (const char c : code) {
    depth += (c == '{' ? 1 : 0) - (c == '}' ? 1 : 0);
    if (depth < 0) return std::nullopt;
  }
  return depth;
}

// The functions that are defined in `code`, which begins within `depth` braces.
std::vector<std::string> functions_in(const std::string& code, int depth) {
  static const RE2 piece(R"((\w+)\s*(\()|([{}()]))");
  std::vector<std::string> names;
  re2::StringPiece rest(code);
  std::string name, call, mark;
  for (int parentheses = 0; RE2::FindAndConsume(&rest, piece, &name, &call, &mark);) {
    if (!call.empty() && depth == 0 && parentheses == 0) names.push_back(name);
    depth += (mark == "{" ? 1 : 0) - (mark == "}" ? 1 : 0);
    parentheses += (!call.empty() || mark == "(" ? 1 : 0) - (mark == ")" ? 1 : 0);
  }
  return names;
}

// A function of those behind the region that `code` declares or calls; "" where it does not.
std::string function_behind(const std::string& code, const std::string& program,
                            const std::string& region) {
  const std::string mark = "// #region " + region;
  const std::size_t begin = program.find(mark), end = behind_region(program, region).value();
  const int depth = depth_of(code_alone(program.substr(0, begin))).value_or(0);
  for (const std::string& name : functions_in(code_alone(program.substr(end)), depth)) {
    if (RE2::PartialMatch(code, "\\b" + name + R"(\s*\()")) return name;
  }
  return "";
}

}  // namespace

std::string refusal(const std::string& text, const ExerciseText& exercise,
                    const std::string& region) {
  // A compiler takes some for blanks, where this does not.
  static const RE2 control(R"([\x00-\x08\x0b\x0c\x0e-\x1f\x7f])");
  if (RE2::PartialMatch(text, control)) return "a region has no control characters";
  const std::string code = code_alone(text), known = code_alone(exercise.solution());
  static const RE2 directive(R"((?m)^\s*(?:#|%:|\?\?=))"), raw(R"(\b(?:u8|[uUL])?R")");
  if (RE2::PartialMatch(code, directive) && !RE2::PartialMatch(known, directive)) {
    return "a region of this exercise has no preprocessor directives";
  }
  if (RE2::PartialMatch(text, raw)) return "a region has no raw strings";
  static const RE2 forging(kForging);
  std::string word;
  if (RE2::PartialMatch(code, forging, &word) && !has_word(known, word)) {
    return "what is written uses `" + word + "`, which no hand-in may";
  }
  if (depth_of(known) == 0 && depth_of(code) != 0) {
    return "a region closes each brace that it opens, and no other";
  }
  const std::string behind = function_behind(code, exercise.program(exercise.solution()), region);
  if (!behind.empty()) {
    return "what is written calls `" + behind + "`, which stands behind the region";
  }
  return "";
}

}  // namespace mjcourse
