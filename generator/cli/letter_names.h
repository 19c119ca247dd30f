// The files of the students' letters.
#pragma once

#include <string>
#include <vector>

namespace mjcourse {

// Of each of `students`, who are folders' names or paths: the same as far as a file may be called
// so and is seen, and no two of which some system makes one.
std::vector<std::string> letter_names(const std::vector<std::string>& students);

}  // namespace mjcourse
