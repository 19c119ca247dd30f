#include "script/script_guard.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "script/exception.h"
#include "script/js_value.h"

namespace mjcourse {
namespace {

// As site/press/script/guards.ts writes them; no text of an author's has them.
constexpr std::array<std::string_view, 3> kMarks{"key$((", "own$((", "))/*$*/"};

std::string name_of(ScriptKind kind) {
  switch (kind) {
    case ScriptKind::script:
      return "script";
    case ScriptKind::value:
      return "value";
    case ScriptKind::assignment:
      return "assignment";
    case ScriptKind::definitions:
      break;
  }
  return "definitions";
}

std::string lines_of(const std::vector<std::string>& names) {
  std::string lines;
  for (const std::string& name : names) lines += (lines.empty() ? "" : "\n") + name;
  return lines;
}

}  // namespace

tl::expected<GuardedScript, ScriptError> ScriptGuard::guard(const std::string& text,
                                                            ScriptKind kind,
                                                            const std::vector<std::string>& names) {
  const auto answer = engine_.call("guard", {text, name_of(kind), lines_of(names)});
  if (!answer) return tl::unexpected(answer.error());
  const nlohmann::json found = json_of(*answer);
  if (found.contains("text")) return GuardedScript{found["text"], found["declares"]};
  ScriptError error;
  error.id = found["id"];
  error.message = found["message"];
  error.cure = error.id == "E-script-syntax" ? cure_of_syntax(error.message)
                                             : found["cure"].get<std::string>();
  error.line = found["line"];
  error.column = found["column"];
  error.width = found["width"];
  return tl::unexpected(std::move(error));
}

std::optional<ExpressionText> ScriptGuard::ask(const std::string& run, const std::string& value,
                                               const std::vector<std::string>& names) {
  const auto answer = engine_.call("ask", {run, value, lines_of(names)});
  if (!answer) return std::nullopt;
  const nlohmann::json found = json_of(*answer);
  return ExpressionText{found["world"], found["callee"], found["values"]};
}

std::string without_guards(std::string text) {
  for (const std::string_view mark : kMarks) {
    for (std::size_t at = 0; (at = text.find(mark, at)) != text.npos;) text.erase(at, mark.size());
  }
  return text;
}

std::size_t place_without_guards(std::string_view text, std::size_t at) {
  std::size_t own = 0;
  for (std::size_t i = 0; i < std::min(at, text.size());) {
    const auto* const mark = std::ranges::find_if(
        kMarks, [&](std::string_view one) { return text.substr(i).starts_with(one); });
    if (mark == kMarks.end()) ++own;
    i += mark == kMarks.end() ? 1 : mark->size();
  }
  return own;
}

}  // namespace mjcourse
