#include "script/compiled_script.h"

#include <algorithm>
#include <utility>

#include "script/exception.h"

namespace mjcourse {

namespace {

constexpr const char* kScriptUrl = "lesson.js";

// around an expression, on lines of their own
constexpr const char* kBeforeValue = "return (\n";
constexpr const char* kAfterValue = "\n);";

// Does `text` parse by itself between `before` and `after`? As a function's body it cannot close
// the wrapper's own braces.
tl::expected<void, ScriptError> check(const Engine& engine, const AuthorText& text,
                                      const std::string& before, const std::string& after,
                                      const CompiledScript::Names& names) {
  constexpr int lines_before = 3;  // "function anonymous(", ") {", and ours
  const std::string body = before + std::string(text.lines().text()) + after;
  JSValueRef thrown = nullptr;
  JSObjectMakeFunction(engine.context(), nullptr, 0, nullptr, JsString("\"use strict\";" + body),
                       JsString(kScriptUrl), 1, &thrown);
  if (thrown == nullptr) return {};
  Exception exception = read_exception(engine.context(), thrown, kScriptUrl);
  int line = exception.line - lines_before;
  if (exception.message == "Parser error") {
    exception.message = kStrayBracket;
    line = std::min(line, text.last_line());
  }
  ScriptError error = explain(exception, names);
  text.point_at(exception, line, error);
  return tl::unexpected(std::move(error));
}

tl::expected<void, ScriptError> check_value(const Engine& engine, const AuthorText& text,
                                            const CompiledScript::Names& names) {
  return check(engine, text, kBeforeValue, kAfterValue, names).map_error([](ScriptError error) {
    error.in_value = true;
    return error;
  });
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
    source += kBeforeValue + *expression + kAfterValue;
    parts.push_back({AuthorText(*expression), lines, true});
  }
  for (const Part& part : parts) {
    const auto sound = part.is_value ? check_value(engine, part.text, names)
                                     : check(engine, part.text, "\n", "", names);
    if (!sound) return tl::unexpected(sound.error());
  }
  const auto function = engine.evaluate(source + "})", kScriptUrl);
  if (!function) return tl::unexpected(engine.describe(function.error()));
  JSObjectRef object = JSValueToObject(engine.context(), *function, nullptr);
  return CompiledScript(std::move(parts), Protected(engine.context(), object));
}

tl::expected<CompiledScript, ScriptError> CompiledScript::compile_assignment(
    Engine& engine, const std::string& target, const Names& names) {
  const AuthorText text(target);
  const auto sound = check_value(engine, text, names);
  if (!sound) return tl::unexpected(sound.error());
  const auto function = engine.evaluate(
      "(function (value) { \"use strict\"; (\n" + target + "\n) = value; })", kScriptUrl);
  if (!function) {  // an expression, but no place to put a value into
    ScriptError error;
    error.id = "E-script-syntax";
    error.message = "this cannot be assigned to";
    error.cure = "name one number: data.ctrl[0], model.opt.gravity[2]";
    text.point_at({}, 1, error);
    return tl::unexpected(std::move(error));
  }
  JSObjectRef object = JSValueToObject(engine.context(), *function, nullptr);
  return CompiledScript({{text, 1, true}}, Protected(engine.context(), object));
}

ScriptError CompiledScript::explain(const Engine& engine, const Engine::Thrown& thrown,
                                    const Names& names) const {
  if (thrown.exception == nullptr) return engine.describe(thrown);
  const Exception exception = read_exception(engine.context(), thrown.exception, kScriptUrl);
  ScriptError error = mjcourse::explain(exception, names);
  error.message = without_guards(std::move(error.message));
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
