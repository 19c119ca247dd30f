#include "lesson/syntax/source_cursor.h"

#include <algorithm>
#include <string_view>

namespace mjcourse {

LocatedText SourceCursor::find(const std::string& part) {
  LocatedText found{part, {}};
  for (std::size_t begin = 0; begin <= part.size();) {
    const std::size_t end = std::min(part.find('\n', begin), part.size());
    const std::size_t size = end - begin;
    std::size_t place = text.text.find(part.substr(begin, size), at);
    // What cmark changed (an escape in a table's cell) is blamed on where the walk is.
    if (place == std::string::npos) {
      place = at;
    } else {
      at = place + size;
    }
    const Offsets stood = text.part(place, std::min(place + size, text.text.size())).offsets;
    found.offsets.append(stood, 0, stood.size());
    found.offsets.append_still(size + 1 - stood.size(), text.span(place + size, 0).begin);
    begin = end + 1;
  }
  return found;
}

void SourceCursor::pass_code(const std::string& code) {
  const std::string& all = text.text;
  const std::string_view here(all.data(), std::min(all.find("\n\n", at), all.size()));
  for (std::size_t found = at; (found = here.find(code, found)) < here.size(); ++found) {
    const std::size_t before = found == 0 ? all.npos : all.find_last_not_of(' ', found - 1);
    if (before == all.npos || all[before] != '`') continue;
    at = found + code.size();
    return;
  }
}

}  // namespace mjcourse
