// Formulas that were none to their author: money, and variables of a shell.
//
// `US$5 to 7$` and `$HOME/$USER` have a dollar where a formula may begin and one where it may end.
#pragma once

#include <string_view>

namespace mjcourse {

// Was the formula `tex`, between the characters `before` its first dollar and the text `behind` its
// last one, meant as text? `before` is '\0' where there is none.
bool is_doubtful_math(char before, std::string_view tex, std::string_view behind);

}  // namespace mjcourse
