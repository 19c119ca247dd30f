// A piece of the author's JavaScript, and where in it to point.
//
// JavaScriptCore tells only the line of a text that does not parse, and for one that runs the
// column of a dot, a bracket or an equal sign. point_at() moves to the name that is wrong.
#pragma once

#include <string>

#include "base/source_text.h"
#include "script/exception.h"
#include "script/script_error.h"
#include "script/script_guard.h"

namespace mjcourse {

// How the message of a text begins whose mistake is what it lacks.
inline constexpr const char* kTooEarly = "the script ends too early: ";

class AuthorText {
 public:
  // `run` is the text as it is run, with guards in it or without (script_guard.h).
  explicit AuthorText(const std::string& run) : lines_("", without_guards(run)), run_("", run) {}

  const SourceText& lines() const { return lines_; }
  // The last line with more than white space and semicolons.
  int last_line() const { return lines_.position(end()).line; }

  // Give `error` its place: line `line` of this text, and there the exception's token nearest to
  // its column, else the column itself, else the whole line. A line past the last means that the
  // text ended too early.
  void point_at(const Exception& exception, int line, ScriptError& error) const;
  // The text ended too early.
  void point_at_end(ScriptError& error) const;

 private:
  std::size_t end() const;

  SourceText lines_;
  SourceText run_;  // line for line the same
};

}  // namespace mjcourse
