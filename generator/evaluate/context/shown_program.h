// Shown programs: what the fences of a course say of each file of examples/.
//
// What a fence shows is what its readers see, so that is what is compiled and run. It is the text
// of the fence that shows the whole file; without one, the file with the lines of its regions'
// fences in it. Where the fences contradict each other, nobody can say what the file should hold.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "course/course.h"

namespace mjcourse {

struct ShownProgram {
  std::vector<const Example*> whole, regions;  // in the course's order
  std::vector<const Exercise*> exercises;      // of which it is the program

  // The fence whose text is the file; null where each shows the file as it is.
  const Example* text() const;
  // Do two fences show the file, or one region of it, with other words?
  bool contradicts_itself() const;
};

// By their files.
using ShownPrograms = std::map<std::string, ShownProgram>;
ShownPrograms shown_programs(const Course& course);

}  // namespace mjcourse
