// ScriptGuard: a lab's script, made fit for the reader's page; and what a proof's script asks.
//
// In the page a script of the author's is code of the site's own. So what it may name is decided
// here, by its text (site/press/script/guard/). What the text cannot tell is asked by two functions
// that are put around it (site/press/script/guards.ts). The generator runs that text as well, so
// what the page would refuse, a build has refused before.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "findings/lab_scripts.h"
#include "script/engine.h"
#include "script/script_error.h"

namespace mjcourse {

struct GuardedScript {
  std::string text;                   // as it is run
  std::vector<std::string> declared;  // by definitions, for the scripts that they stand before
};

// What the text of an expression tells (site/press/script/guard/asked.ts).
struct ExpressionText {
  bool world = false;          // it names the model or its data, or what `run` made of them
  std::string callee, values;  // `f` and `a, b` of `f(a, b)`, where `run` declares f; else ""
};

class ScriptGuard {
 public:
  // `bundle` is the text of script/guard.js.
  explicit ScriptGuard(const std::string& bundle) { engine_.load(bundle, "guard.js"); }

  // What is run of `text`, which may use `names`; or why it is not. One that does not parse is
  // E-script-syntax, without a place (line 0) where it ends too early.
  tl::expected<GuardedScript, ScriptError> guard(const std::string& text, ScriptKind kind,
                                                 const std::vector<std::string>& names);

  // What `value` asks for, which sees what `run` declares. Nothing of texts that do not parse.
  std::optional<ExpressionText> ask(const std::string& run, const std::string& value,
                                    const std::vector<std::string>& names);

 private:
  Engine engine_;
};

// The author's of a text with guards.
std::string without_guards(std::string text);
// Where byte `at` of `text`, which has guards, is in the author's: within a guard, where it stands.
std::size_t place_without_guards(std::string_view text, std::size_t at);

}  // namespace mjcourse
