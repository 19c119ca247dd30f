// Highlighter: source code to HTML whose `hljs-…` classes the stylesheet colours, by highlight.js.
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
