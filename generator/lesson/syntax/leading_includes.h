// What a program includes before its first line of code.
//
// Up to there nothing but comments and includes was said, so nothing can have used a name yet. That
// is what lets a compiled header (warm_header.h) stand in for some of them.
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

}  // namespace mjcourse
