// Diagnostics as a person reads them in a terminal.
//
//   content/1-state/1.2-….md:41:34: error: data.qpso does not exist [E-script-name]
//     41 |   {"label": "w", "expr": "data.qpso[3]"},
//        |                           ^~~~~~~~~
//     cure: did you mean `data.qpos`?
#pragma once

#include <string>

#include "report/diagnostic.h"

namespace mjcourse {

struct TerminalStyle {
  bool colours = false;  // ANSI; never the only bearer of a meaning
  int width = 100;       // columns; a longer source line is cut around the caret
};

// The diagnostic's text, ending in a newline.
std::string format_for_terminal(const Diagnostic& diagnostic, const TerminalStyle& style = {});

}  // namespace mjcourse
