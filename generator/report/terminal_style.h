// How text is set for its reader: what that terminal can show, and how wide it is.
#pragma once

namespace mjcourse {

struct TerminalStyle {
  bool colours = false;  // ANSI; never the only bearer of a meaning
  int width = 100;       // columns; a longer source line is cut around the caret
  bool wraps = false;    // do longer sentences go on in a line of their own
};

// For the reader of `descriptor`. A terminal says how wide it is, unless COLUMNS says otherwise; a
// pipe or a file gets long lines, for others than eyes.
TerminalStyle style_for(int descriptor);

}  // namespace mjcourse
