// What hand-ins came to, as text for people and for other tools.
// Tested by tests/generator/cli/grades_test.cpp.
#pragma once

#include <string>
#include <vector>

#include "cli/commands.h"
#include "cli/exercise_list.h"
#include "evaluate/hand_in.h"

namespace mjcourse {

// Of one exercise in one hand-in.
struct Grade {
  std::string exercise, lesson;
  bool handed_in = false;
  Verdict verdict = {};
  double most = 0;  // points that can be had
};

struct GradedHandIn {
  std::string folder;
  std::vector<Grade> grades;
};

std::string grades_text(const std::vector<GradedHandIn>& graded, GradeFormat format);

}  // namespace mjcourse
