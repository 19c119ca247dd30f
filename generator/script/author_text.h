// A piece of the author's JavaScript, and where in it to point.
//
// JavaScriptCore tells only the line of a text that does not parse, and for one that runs the
// column of a dot, a bracket or an equal sign. point_at() moves to the name that is wrong.
#pragma once

#include <string>
#include <utility>

#include "base/source_text.h"
#include "script/exception.h"
#include "script/script_error.h"

namespace mjcourse {

class AuthorText {
 public:
  explicit AuthorText(std::string text) : lines_("", std::move(text)) {}

  const SourceText& lines() const { return lines_; }
  // The last line with more than white space and semicolons.
  int last_line() const { return lines_.position(end()).line; }

  // Give `error` its place: line `line` of this text, and there the exception's token nearest to
  // its column, else the column itself, else the whole line. A line past the last means that the
  // text ended too early.
  void point_at(const Exception& exception, int line, ScriptError& error) const;

 private:
  std::size_t end() const;

  SourceText lines_;
};

}  // namespace mjcourse
