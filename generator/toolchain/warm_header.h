// The warm header: what costs the compiler most of its time, compiled once.
//
// A program that forgets an include must fail here as it does at its reader's. So a program gets a
// compiled header only of headers that it includes itself, and only where nothing but comments and
// the standard library's includes stand before them. Then every name that the compiled header
// brings is one that the program may use, and none came earlier than a reader's compiler sees it.
// Nobody need check afterwards what was used.
//
// Behind them stands what programs mostly do with Eigen (warm_eigen.hpp), in a namespace that none
// uses: its templates are then made.
//
// The roots of such a header are the course's own headers (include_folders.h) that the program
// includes, which bring Eigen and MuJoCo with them; where it includes none, Eigen's. Of a header
// that begins with another one of the course, the root is that one. A compiled header takes seconds
// to make and 100 MB to keep, and so one serves nearly all programs of a course.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "toolchain/include_folders.h"

namespace mjcourse {

// The headers, in their order, whose compiled form may stand in for the includes of `program`;
// none where there is nothing to gain. `include` has the course's own headers.
std::vector<std::string> warm_roots(std::string_view program, const IncludeFolders& include);

}  // namespace mjcourse
