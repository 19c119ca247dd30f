#include "lesson/syntax/html_tags.h"

#include <algorithm>

#include "base/utf8.h"

namespace mjcourse {
namespace {

// Where the tag ends whose name ends at `at`: behind the next `>` that no quotes hold; npos where
// there is none.
std::size_t end_of_tag(std::string_view html, std::size_t at) {
  for (; at < html.size(); ++at) {
    if (html[at] == '>') return at + 1;
    if (html[at] == '"' || html[at] == '\'')
      at = std::min(html.find(html[at], at + 1), html.size());
  }
  return html.npos;
}

}  // namespace

std::vector<HtmlTag> tags_of_html(std::string_view html) {
  std::vector<HtmlTag> tags;
  for (std::size_t at = 0; (at = html.find('<', at)) < html.size();) {
    const std::size_t begin = at;
    if (html.substr(at).starts_with("<!--")) {
      const std::size_t end = html.find("-->", at + 4);
      if (end == html.npos) break;
      at = end + 3;
      tags.push_back({begin, at, "", false});
      continue;
    }
    const bool closes = html.substr(at).starts_with("</");
    const std::size_t name = at + (closes ? 2 : 1);
    const std::size_t name_end = std::min(html.find_first_of(" \t\n/>", name), html.size());
    const std::size_t end = end_of_tag(html, name_end);
    if (end == html.npos) break;
    at = end;
    tags.push_back({begin, end, lower_case_utf8(html.substr(name, name_end - name)), closes});
  }
  return tags;
}

}  // namespace mjcourse
