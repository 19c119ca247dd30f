// What a C++ program includes, and what it is linked with for that.
//
// Up to its first line of code a program says nothing but comments and includes, so nothing can
// have used a name yet. That is what lets a compiled header (toolchain/warm_header.h) stand in for
// some of them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace mjcourse {

struct Include {
  std::string name;     // "vector", "Eigen/Dense"
  bool angled = false;  // <vector>, and not "vector"
};

// In their order, up to the first token that is neither a comment, nor `#line`, nor `#pragma
// once`, nor an include. An include of a form that is not understood here (a macro, words
// behind it) ends the list too.
std::vector<Include> leading_includes(std::string_view program);

// The names of `#include "name.h"`, which its reader's compiler looks for beside the program first,
// in their order; also those that a condition leaves out.
std::vector<std::string> quoted_includes(std::string_view program);

// Does it draw without a screen: does it include <GL/osmesa.h>?
bool draws(std::string_view program);

// The names of its libraries, as they stand behind -l: MuJoCo, and OSMesa where the program draws.
std::vector<std::string> linked_libraries(std::string_view program);

}  // namespace mjcourse
