// Raw HTML in Markdown: what of it a lesson may use.
//
// A lesson's text goes into the reader's browser as it stands, and it may come from a stranger. So
// it is a list of what may stand there, of elements that only mark text and of attributes that only
// describe them; all else is refused. Tags are read more strictly than browsers read them, so what
// passes here means the same there.
// Tested by tests/generator/lesson/blocks/read_html_test.cpp.
#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace mjcourse {

// May a lesson have the element `name`, which is in small letters?
bool is_lesson_element(std::string_view name);

// Something that may not stand in a lesson, and where in the text.
struct HtmlFault {
  std::size_t begin, end;
  std::string id, message, cure;
};

// `refused` are the names of the lesson's elements that were refused before, and then those of
// `html` as well.
std::vector<HtmlFault> faults_of_html(std::string_view html, std::set<std::string>& refused);

}  // namespace mjcourse
