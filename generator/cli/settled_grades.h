// Many texts are judged side by side, and what the others may have brought about once more, alone.
//
// The clock of a program runs while others have the processors, and the memory is everybody's: a
// right text that is slow would get no points since others are slower.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "cli/grades.h"

namespace mjcourse {

// How texts are judged, and who hears of it.
struct GradeWork {
  std::function<Grade(std::size_t)> judge;  // from several threads, and at the end from one
  std::function<void(std::size_t, const Grade&)> done;  // of each, once, when its grade is settled
  std::function<void(std::size_t texts)> again;         // before so many are judged once more
};

// Of texts below `count`, with `jobs` at once; each is judged at most twice.
std::vector<Grade> settled_grades(std::size_t count, std::size_t jobs, const GradeWork& work);

}  // namespace mjcourse
