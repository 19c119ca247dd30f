// Explaining: what each task depends on, whether its finding is kept, and if not, what has changed.
//
// Nothing is worked out. So what quotes a program that would have to run is not known to be kept.
// Tested by tests/store/dependencies.mjs.
#pragma once

#include <string>
#include <vector>

#include "cache/dependency.h"
#include "course/course.h"
#include "evaluate/evaluate.h"

namespace mjcourse {

struct Explanation {
  std::string what;  // "rehearse the lab …"
  Place place;
  bool kept = false;
  std::string result;  // where it is kept, its name in the store
  bool made_here = false;
  Dependencies now;     // all that it depends on, as far as that is known
  Dependencies before;  // when it was last worked out or found here; empty where it never was
};

// One for each task whose finding can be kept, in the course's order. With `puts_lists`, the way to
// each kept finding that was made here is put into the store anew (task_store.h).
std::vector<Explanation> explain_course(const Course& course, const EvaluationSettings& settings,
                                        bool puts_lists = false);

}  // namespace mjcourse
