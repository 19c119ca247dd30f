#include "lesson/syntax/inline_length.h"

#include <algorithm>

namespace mjcourse {

std::size_t backticks(std::string_view text) {
  return std::min(text.find_first_not_of('`'), text.size());
}

std::size_t CodeLengths::at(std::string_view rest) {
  const std::size_t opening = backticks(rest);
  if (unclosed_.contains(opening)) return 0;
  for (std::size_t at = opening; (at = rest.find('`', at)) < rest.size();) {
    const std::size_t closing = backticks(rest.substr(at));
    at += closing;
    if (closing == opening) return at;
  }
  unclosed_.insert(opening);
  return 0;
}

}  // namespace mjcourse
