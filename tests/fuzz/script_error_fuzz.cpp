// What a script throws, of any properties: in words, and at a place of the lesson.
//
// The input: a line that nobody reads, then what is thrown, as JSON.
#include "diagnostic_check.h"
#include "evaluate/context/script_place.h"
#include "fuzz.h"
#include "require.h"
#include "script/author_text.h"
#include "script/exception.h"
#include "script/javascriptcore.h"
#include "script/js_value.h"

namespace mjcourse {
namespace {

// The generator has no use for it.
const LateFunction<kScriptEngine, decltype(::JSValueMakeFromJSONString)> value_of_json(
    "JSValueMakeFromJSONString");

JSGlobalContextRef context() {
  static JSGlobalContextRef one = JSGlobalContextCreateInGroup(nullptr, nullptr);
  return one;
}

void check_thrown(JSValueRef thrown) {
  const Exception exception = read_exception(context(), thrown, "lesson.js");
  ScriptError error = explain(exception, {"data", "model", "qpos"});
  const std::string path = "content/1-a/1.1-x.md", script = "data.qpos[0] +\n'ü' + x\n";
  const SourceText lesson(path, "Run:\n" + script);
  AuthorText(script).point_at(exception, exception.line, error);
  const LocatedText text = located(lesson, {5, 5 + script.size()});
  Diagnostic found = script_diagnostic(error, text, lesson);
  if (found.message.empty()) found.message = "thrown without a word";
  require(found.id.starts_with("E-script-"), "an id of ours: " + found.id);
  check_diagnostics({found}, {{path, lesson}});
}

}  // namespace
}  // namespace mjcourse

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string input = mjcourse::text_of_input(data, size);
  const std::size_t line = std::min(input.find('\n'), input.size());
  JSValueRef thrown = mjcourse::value_of_json(
      mjcourse::context(), mjcourse::JsString(input.substr(std::min(line + 1, input.size()))));
  if (thrown != nullptr) mjcourse::check_thrown(thrown);
  return 0;
}
