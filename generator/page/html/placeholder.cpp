#include "page/html/placeholder.h"

namespace mjcourse {

std::string placeholder(std::string_view name) {
  return '\x02' + std::string(name) + '\x03';
}

bool fill_placeholder(std::string& html, std::string_view name, std::string_view text) {
  const std::string mark = placeholder(name);
  const std::size_t at = html.find(mark);
  if (at == html.npos || html.find(mark, at + mark.size()) != html.npos) return false;
  html.replace(at, mark.size(), text);
  return true;
}

}  // namespace mjcourse
