#include "script/script_guard.h"

#include <nlohmann/json.hpp>
#include <string_view>

#include "script/exception.h"
#include "script/js_value.h"

namespace mjcourse {
namespace {

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

// As site/press/script/guards.ts writes them; no text of an author's has them.
std::string without_guards(std::string text) {
  for (const std::string_view mark : {"key$((", "own$((", "))/*$*/"}) {
    for (std::size_t at = 0; (at = text.find(mark, at)) != text.npos;) text.erase(at, mark.size());
  }
  return text;
}

}  // namespace mjcourse
