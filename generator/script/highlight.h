// Highlighter: source code to HTML by highlight.js; the stylesheet colours its `hljs-…` classes.
#pragma once

#include <string>

#include "script/engine.h"

namespace mjcourse {

class Highlighter {
 public:
  // `bundle` is the text of script/highlight.js.
  explicit Highlighter(const std::string& bundle);

  // A language that the bundle does not know gives the text escaped and plain.
  std::string highlight(const std::string& code, const std::string& language);

 private:
  Engine engine_;
};

}  // namespace mjcourse
