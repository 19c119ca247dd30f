#include "report/colours.h"

#include <unistd.h>

#include <cstdlib>

namespace mjcourse {

bool wants_colours(int descriptor) {
  const char* refused = std::getenv("NO_COLOR");
  const char* kind = std::getenv("TERM");
  return isatty(descriptor) != 0 && (refused == nullptr || *refused == '\0') &&
         (kind == nullptr || std::string_view(kind) != "dumb");
}

}  // namespace mjcourse
