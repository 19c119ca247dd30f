// Diagnostics as a person reads them in a terminal.
//
//   content/1-state/1.2-….md:41:34: error: data.qpso does not exist [E-script-name]
//     41 |   {"label": "w", "expr": "data.qpso[3]"},
//        |                           ^~~~~~~~~
//     cure: did you mean `data.qpos`?
#pragma once

#include <string>

#include "report/diagnostic.h"
#include "report/terminal_style.h"

namespace mjcourse {

// The diagnostic's text, ending in a newline.
std::string format_for_terminal(const Diagnostic& diagnostic, const TerminalStyle& style = {});

// All of them, each with an empty line behind it; and for eyes, which command tells more.
std::string format_for_terminal(const Diagnostics& diagnostics, const TerminalStyle& style);

}  // namespace mjcourse
