// A JavaScript exception, read out into C++ and put into words.
// Tested by tests/generator/script/world_test.cpp.
#pragma once

#include <string>
#include <vector>

#include "script/javascriptcore.h"
#include "script/script_error.h"

namespace mjcourse {

struct Exception {
  std::string kind;     // "SyntaxError", "TypeError" …; "" for a thrown value that is no Error
  std::string message;  // without the kind

  // The innermost place in the script asked for; 0 when it has none.
  int line = 0;  // from 1
  int column =
      0;  // from 1, in UTF-16 units; JavaScriptCore points at dots, brackets and equal signs

  // Names in the script to underline, best first.
  std::vector<std::string> tokens;

  // What the strict layer adds (site/press/script/fault.ts); empty on other exceptions.
  std::string id;
  std::string cure;
};

// `url` is that of the script whose line is wanted.
Exception read_exception(JSContextRef context, JSValueRef exception, const std::string& url);

// What went wrong, without a place; `names` are those that a script may use.
ScriptError explain(const Exception& exception, const std::vector<std::string>& names);

// The message on a text with a closing bracket too many. The engine's own words differ.
inline constexpr const char* kStrayBracket = "a closing bracket has no opening one";

// What to do about a text that does not parse, where `message` says why.
std::string cure_of_syntax(const std::string& message);

}  // namespace mjcourse
