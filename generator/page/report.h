// The report of one run, for the author who mends a course: a page that opens by itself, and the
// same for tools.
//
// Steps: verification.json has everything; index.html shows it, with the mistakes first; pictures/
// has what is pinned, as it was and as it was drawn now. It is made of a failed run as well.
// Tested by tests/generator/cli/verify_test.cpp.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "course/course.h"
#include "findings/evaluation.h"

namespace mjcourse {

struct Run {
  const Course* course;  // null where there is no readable one
  const Evaluation& evaluation;
  double seconds;
};

// Replaces what an earlier report left in `out`, be that in the folder `course` or elsewhere.
// `assets` is what site/bundle/build.mjs made. Throws as write_site does.
void write_report(const Run& run, const std::filesystem::path& assets,
                  const std::filesystem::path& out, const std::filesystem::path& course);

}  // namespace mjcourse
