// What an SVG of a course may not hold.
//
// A drawing that a page shows runs no script, but the same file can be opened by its address, and
// then it is a page of the site with all that a page may do. So it is a list of what a drawing
// needs, and whatever else is there is refused: script, foreign content, what moves. So is every
// address but that of a part of the drawing itself and of a picture within it.
#pragma once

#include <string>
#include <vector>

#include "base/source_text.h"

namespace mjcourse {

struct SvgFault {
  Span span;
  std::string message, cure;
};

// Of `bytes`, each kind once, a hundred at most. Where they are not XML as browsers read it, what
// comes behind is not looked at.
std::vector<SvgFault> faults_of_svg(const std::string& bytes);

// Whether a drawing can stand in a page, where a browser reads it as HTML and the page's scripts
// and styles find it. It may have no characters that HTML alone knows, no ids but those that begin
// with `name`, and no class but ours.
bool is_part_of_page(const std::string& bytes, const std::string& name);

}  // namespace mjcourse
