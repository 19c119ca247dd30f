#include "report/terminal_style.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <string_view>

#include "report/colours.h"

namespace mjcourse {
namespace {

constexpr int kLeast = 40;  // columns; a narrower terminal breaks the lines by itself

// 0 where it is not known.
int columns_of(int terminal) {
  int columns = 0;
  if (const char* said = std::getenv("COLUMNS")) {
    const std::string_view text(said);
    const auto read = std::from_chars(text.data(), text.data() + text.size(), columns);
    if (read.ptr == text.data() + text.size() && columns > 0) return columns;
  }
  winsize size{};
  return ioctl(terminal, TIOCGWINSZ, &size) == 0 ? size.ws_col : 0;
}

}  // namespace

TerminalStyle style_for(int descriptor) {
  TerminalStyle style;
  style.colours = wants_colours(descriptor);
  if (isatty(descriptor) == 0) return style;
  style.wraps = true;
  // A source line that is cut at both ends takes one column more than the width.
  if (const int columns = columns_of(descriptor)) style.width = std::max(kLeast, columns) - 1;
  return style;
}

}  // namespace mjcourse
