// What the files of a program are called where somebody else builds it: in the folder that the page
// offers, and for the compiler of the page.
// Tested by tests/generator/page/program_folder_test.cpp.
#pragma once

#include <string>

#include "lesson/blocks/block.h"

namespace mjcourse {

// Of `path` of the course. What lies beside the program, does so there.
std::string path_in_folder(const std::string& path, const Example& example);

}  // namespace mjcourse
