#include "page/html/placeholder.h"

namespace mjcourse {

std::string placeholder(std::string_view name) {
  return '\x02' + std::string(name) + '\x03';
}

void fill_placeholder(std::string& html, std::string_view name, std::string_view text) {
  const std::string mark = placeholder(name);
  html.replace(html.find(mark), mark.size(), text);
}

}  // namespace mjcourse
