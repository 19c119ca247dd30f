// A script of the author's as a function that JavaScriptCore can call, and its errors in that text.
//
// Four kinds share one shape: a script; an expression; a script with an expression that sees its
// variables; and an expression that is assigned to. Each is a text inside a strict function whose
// wrapper takes whole lines, so that columns stay as they are. The third is a generator function,
// which stops between the two: time can pass there, and each half has a time limit of its own.
// Tested by tests/generator/script/world_test.cpp.
#pragma once

#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "script/author_text.h"
#include "script/engine.h"
#include "script/javascriptcore.h"
#include "script/js_value.h"
#include "script/script_error.h"

namespace mjcourse {

class CompiledScript {
 public:
  // What a script may use, for "did you mean".
  using Names = std::vector<std::string>;

  // At least one of `script` and `expression` is there. The engine must outlive what it compiled.
  static tl::expected<CompiledScript, ScriptError> compile(
      Engine& engine, const std::optional<std::string>& script,
      const std::optional<std::string>& expression, const Names& names);

  // A function of one argument, which `target` is set to.
  static tl::expected<CompiledScript, ScriptError> compile_assignment(Engine& engine,
                                                                      const std::string& target,
                                                                      const Names& names);

  // Runs the script or gives the expression's value. With both it gives an iterator: its first
  // next() runs the script, its second has the value.
  JSObjectRef function() const { return function_; }

  // What ended a call of this function, at its place in the author's text.
  ScriptError explain(const Engine& engine, const Engine::Thrown& thrown, const Names& names) const;

  // Point `error` at all of the expression.
  void point_at_value(ScriptError& error) const;

 private:
  // A text of the author's, and how many lines of the wrapper stand before it.
  struct Part {
    AuthorText text;
    int lines_before;
    bool is_value;
  };

  CompiledScript(std::vector<Part> parts, Protected function);

  std::vector<Part> parts_;
  Protected function_;
};

}  // namespace mjcourse
