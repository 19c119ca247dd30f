// Headings of a lesson.
// Tested by tests/generator/lesson/read_lesson_test.cpp.
// Tested by tests/courses/text.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "lesson/blocks/lesson.h"
#include "lesson/syntax/reading.h"

namespace mjcourse {

// Those that a lesson's headings have so far.
struct HeadingIds {
  std::set<std::string> used;
  std::map<std::string, int> numbers;  // the last behind each slug that stands twice
};

// But for its title, which is known once what stands in it was read.
Heading read_heading(cmark_node* node, HeadingIds& ids, Reading& reading);
std::vector<TitlePart> title_of_heading(cmark_node* node, const Lesson& lesson);

}  // namespace mjcourse
