// The tags of raw HTML, as far as it is whole: raw_html.h says where it is not.
// Tested by tests/generator/lesson/blocks/read_html_test.cpp.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace mjcourse {

// A tag, or a comment, which has no name.
struct HtmlTag {
  std::size_t begin, end;
  std::string name;  // in small letters
  bool closes;       // `</name>`
};
std::vector<HtmlTag> tags_of_html(std::string_view html);

}  // namespace mjcourse
