#include "script/exception.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <sstream>
#include <string_view>

#include "base/nearest.h"
#include "script/js_value.h"

namespace mjcourse {

namespace {

constexpr std::string_view unknown_variable = "Can't find variable: ";

// A property that is a string; "" for any other.
std::string string_property(JSContextRef context, JSObjectRef object, const char* name) {
  JSValueRef value = property(context, object, name);
  return JSValueIsString(context, value) ? text_of(context, value) : "";
}

// A script may throw anything, and say of it what it likes: a line, or how many tokens there are.
constexpr int kMostLines = 1'000'000, kMostTokens = 10;

// Of what is said to be line or column `number`; 0 where there is none.
int sensible(double number) {
  return number >= 1 && number <= kMostLines ? static_cast<int>(number) : 0;
}

int count_property(JSContextRef context, JSObjectRef object, const char* name) {
  return sensible(JSValueToNumber(context, property(context, object, name), nullptr));
}

// The first frame of `url` on a stack of lines `function@url:line:column`.
void find_frame(const std::string& stack, const std::string& url, Exception& exception) {
  std::istringstream frames(stack);
  const std::string mark = "@" + url + ":";
  for (std::string frame; std::getline(frames, frame);) {
    const std::size_t at = frame.find(mark);
    if (at == std::string::npos) continue;
    char* rest = nullptr;
    exception.line = sensible(std::strtod(frame.c_str() + at + mark.size(), &rest));
    if (*rest == ':') exception.column = sensible(std::strtod(rest + 1, nullptr));
    return;
  }
}

std::vector<std::string> strict_tokens(JSContextRef context, JSObjectRef error) {
  std::vector<std::string> tokens;
  JSObjectRef array = object_in(context, property(context, error, "tokens"));
  if (array == nullptr) return tokens;
  const int count = std::min(count_property(context, array, "length"), kMostTokens);
  for (unsigned i = 0; i < static_cast<unsigned>(count); ++i) {
    tokens.push_back(text_of(context, JSObjectGetPropertyAtIndex(context, array, i, nullptr)));
  }
  return tokens;
}

// What JavaScriptCore's own message names: a variable, or the first text between quotes.
std::vector<std::string> named_tokens(std::string_view message) {
  if (message.starts_with(unknown_variable)) {
    return {std::string(message.substr(unknown_variable.size()))};
  }
  const std::size_t open = message.find(" '");
  if (open == std::string_view::npos) return {};
  const std::string_view quoted = message.substr(open + 2);
  const std::size_t close = quoted.find_first_of('\'');
  if (close == std::string_view::npos) return {};
  return {std::string(quoted.substr(0, close))};
}

}  // namespace

Exception read_exception(JSContextRef context, JSValueRef exception, const std::string& url) {
  Exception result;
  JSObjectRef error = object_in(context, exception);
  if (error != nullptr) result.kind = string_property(context, error, "name");
  if (result.kind.empty()) {
    result.message = text_of(context, exception);
    return result;
  }
  result.message = string_property(context, error, "message");
  result.id = string_property(context, error, "id");
  result.cure = string_property(context, error, "cure");
  result.tokens = strict_tokens(context, error);
  if (result.tokens.empty()) result.tokens = named_tokens(result.message);
  find_frame(string_property(context, error, "stack"), url, result);
  // a text that does not parse never ran, so it has no frame
  if (result.line == 0 && string_property(context, error, "sourceURL") == url) {
    result.line = count_property(context, error, "line");
  }
  return result;
}

namespace {

// The ids of the strict layer (site/press/script/fault.ts) and of the world beneath it. Another is
// of the script's own making.
bool is_fault(const std::string& id) {
  constexpr std::array<std::string_view, 5> known{
      "E-script-foreign", "E-script-name", "E-script-range", "E-script-value", "E-script-mujoco"};
  return std::ranges::find(known, id) != known.end();
}

}  // namespace

std::string cure_of_syntax(const std::string& message) {
  if (message == kStrayBracket) return "remove it, or open it";
  const bool is_second = message.find("already been declared") != message.npos ||
                         message.find("Cannot declare") != message.npos;
  return is_second ? "choose another name"
                   : "look for a missing bracket, quote or operator just before this";
}

ScriptError explain(const Exception& exception, const std::vector<std::string>& names) {
  ScriptError error;
  error.message = exception.message;
  if (is_fault(exception.id)) {
    error.id = exception.id;
    error.cure = exception.cure;
  } else if (exception.kind == "SyntaxError") {
    error.id = "E-script-syntax";
    error.cure = cure_of_syntax(exception.message);
  } else if (exception.message.starts_with(unknown_variable)) {
    const std::string name = exception.message.substr(unknown_variable.size());
    error.id = "E-script-name";
    error.message = "`" + name + "` does not exist";
    error.cure = suggest(name, names);
  } else if (exception.message.starts_with("Maximum call stack size exceeded")) {
    error.id = "E-script-throw";
    error.message = "calls or brackets are nested too deep";
  } else {
    error.id = "E-script-throw";
    const bool plain = exception.kind.empty() || exception.kind == "Error";
    if (!plain) error.message = exception.kind + ": " + exception.message;
  }
  return error;
}

}  // namespace mjcourse
