// A snippet as a program: under which name its reader edits, runs and takes it along.
// Tested by tests/generator/page/program_folder_test.cpp.
#pragma once

#include <cstddef>

#include "lesson/blocks/lesson.h"

namespace mjcourse {

// Of the snippet that the block is. "snippets/snippet_1_2_3.cpp" is that of the third snippet of
// lesson 1.2: no example's, as these are in examples/. The text is ExampleResult::code.
Example snippet_program(const Lesson& lesson, std::size_t block);

// Was it made by the former?
bool is_snippet_program(const Example& program);

}  // namespace mjcourse
