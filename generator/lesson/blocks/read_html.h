// Raw HTML of a lesson, a block of lines or a tag in a line (raw_html.h).
#pragma once

#include <set>
#include <string>

#include "lesson/syntax/located_text.h"
#include "lesson/syntax/open_elements.h"
#include "lesson/syntax/reading.h"

namespace mjcourse {

// What is remembered from one piece of HTML to the next of a lesson.
struct HtmlState {
  std::set<std::string> refused;  // names of elements
  OpenElements open;
};

// `html` is the text of `node`.
void read_html(cmark_node* node, const LocatedText& html, HtmlState& state, Reading& reading);

}  // namespace mjcourse
