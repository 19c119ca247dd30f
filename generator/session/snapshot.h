// Snapshot: a course and what is known of it at one moment.
#pragma once

#include <memory>

#include "course/course.h"
#include "evaluate/evaluate.h"

namespace mjcourse {

struct Snapshot {
  Course course;
  // Of this course; open where work is going on. One that still holds is shared.
  std::shared_ptr<const Evaluation> evaluation = std::make_shared<Evaluation>();
  Diagnostics diagnostics;  // all that is to be shown, in the order of the files and lines
  Diagnostics of_work;      // those of them that reading does not find
  bool readable = false;    // false: there is no course.yaml to read, and this course is empty
  bool guessed = false;     // nobody has looked yet whether the edit changed more than text
};

using SnapshotPtr = std::shared_ptr<const Snapshot>;

}  // namespace mjcourse
