// Highlighter: source code to HTML by highlight.js; the stylesheet colours its `hljs-…` classes.
#pragma once

#include <string>

#include "script/engine.h"
#include "script/memory.h"

namespace mjcourse {

class Highlighter {
 public:
  // `bundle` is the text of script/highlight.js; `memory`, in bytes, is for what was highlighted.
  explicit Highlighter(const std::string& bundle, std::size_t memory = kLittleMemory);

  // A language that the bundle does not know gives the text escaped and plain.
  std::string highlight(const std::string& code, const std::string& language);

 private:
  Engine engine_;
  Memory known_;
};

}  // namespace mjcourse
