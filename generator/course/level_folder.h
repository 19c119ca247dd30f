// A level's folder: its name in `content/`, and in the site the folder of its lessons' pages.
// Tested by tests/generator/course/read_course_test.cpp.
#pragma once

#include <optional>
#include <string>

#include "base/plain_name.h"

namespace mjcourse {

// Why no level has the folder `name`; nothing where one may.
std::optional<NameFault> fault_of_level_folder(const std::string& name);

// Does a file of the site, of those at its root or of those that are made beside others, end like
// this folder? It could have its very name.
bool ends_as_a_file(const std::string& folder);

}  // namespace mjcourse
