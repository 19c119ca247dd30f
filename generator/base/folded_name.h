// Names of people and files that are one to those who read them.
//
// "é" is one character, or a letter with an accent, by the system that wrote it; some file systems
// tell capitals apart, and others do not.
#pragma once

#include <string>
#include <string_view>

namespace mjcourse {

// The same for all spellings of `name`. U+FFFD stands for what is no UTF-8.
std::string folded_name(std::string_view name);

}  // namespace mjcourse
