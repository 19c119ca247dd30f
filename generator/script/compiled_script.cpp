#include "script/compiled_script.h"

#include <algorithm>
#include <utility>

#include "script/exception.h"

namespace mjcourse {

namespace {

constexpr const char* url = "lesson.js";

// around an expression, on lines of their own
constexpr const char* before_value = "return (\n";
constexpr const char* after_value = "\n);";

// Does `text` parse by itself? As a function's body it cannot close the wrapper's own braces.
tl::expected<void, ScriptError> check(const Engine& engine, const AuthorText& text, bool is_value,
                                      const CompiledScript::Names& names) {
  constexpr int lines_before = 3;  // "function anonymous(", ") {", and ours
  const std::string author(text.lines().text());
  const std::string body = is_value ? before_value + author + after_value : "\n" + author;
  JSValueRef thrown = nullptr;
  JSObjectMakeFunction(engine.context(), nullptr, 0, nullptr, JsString("\"use strict\";" + body),
                       JsString(url), 1, &thrown);
  if (thrown == nullptr) return {};
  Exception exception = read_exception(engine.context(), thrown, url);
  int line = exception.line - lines_before;
  if (exception.message == "Parser error") {
    exception.message = "a closing bracket has no opening one";
    line = std::min(line, text.last_line());
  }
  ScriptError error = explain(exception, names);
  error.in_value = is_value;
  text.point_at(exception, line, error);
  return tl::unexpected(std::move(error));
}

}  // namespace

CompiledScript::CompiledScript(std::vector<Part> parts, Protected function)
    : parts_(std::move(parts)), function_(std::move(function)) {}

tl::expected<CompiledScript, ScriptError> CompiledScript::compile(
    Engine& engine, const std::optional<std::string>& script,
    const std::optional<std::string>& expression, const Names& names) {
  std::vector<Part> parts;
  std::string source =
      script && expression ? "(function* () { \"use strict\";" : "(function () { \"use strict\";";
  int lines = 1;
  if (script) {
    source += "\n" + *script + "\n;";
    parts.push_back({AuthorText(*script), lines, false});
    lines += parts.back().text.lines().line_count() + 1;
  }
  if (script && expression) source += "yield;";
  if (expression) {
    source += before_value + *expression + after_value;
    parts.push_back({AuthorText(*expression), lines, true});
  }
  for (const Part& part : parts) {
    const auto sound = check(engine, part.text, part.is_value, names);
    if (!sound) return tl::unexpected(sound.error());
  }
  const auto function = engine.evaluate(source + "})", url);
  if (!function) return tl::unexpected(engine.describe(function.error()));
  JSObjectRef object = JSValueToObject(engine.context(), *function, nullptr);
  return CompiledScript(std::move(parts), Protected(engine.context(), object));
}

ScriptError CompiledScript::explain(const Engine& engine, const Engine::Thrown& thrown,
                                    const Names& names) const {
  if (thrown.exception == nullptr) return engine.describe(thrown);
  const Exception exception = read_exception(engine.context(), thrown.exception, url);
  ScriptError error = mjcourse::explain(exception, names);
  const Part* part = nullptr;
  for (const Part& candidate : parts_) {
    if (exception.line > candidate.lines_before) part = &candidate;
  }
  if (part == nullptr) return error;
  error.in_value = part->is_value;
  part->text.point_at(exception, exception.line - part->lines_before, error);
  return error;
}

void CompiledScript::point_at_value(ScriptError& error) const {
  error.in_value = true;
  parts_.back().text.point_at({}, 1, error);
}

}  // namespace mjcourse
