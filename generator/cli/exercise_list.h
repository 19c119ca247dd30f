// The exercises of a course, as the command line names them.
// Tested by tests/system/try.mjs.
#pragma once

#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "cli/new_files.h"
#include "course/course.h"
#include "findings/result.h"

namespace mjcourse {

struct ListedExercise {
  const Lesson* lesson;
  const Exercise* exercise;
  std::string name;   // "l0_1_millimetre"
  std::string title;  // of the callout that it stands in; may be empty
};

// In the course's order; those of drafts as well.
std::vector<ListedExercise> exercises_of(const Course& course);

// The one that is meant by a lesson, as find_place() takes it, and a name, which may be left out
// where the lesson has one exercise.
tl::expected<ListedExercise, Refusal> find_exercise(const Course& course,
                                                    const std::filesystem::path& root,
                                                    const std::vector<std::string>& words);

// A check as a terminal shows it: a sign and what it says; below, what it means that it fails.
std::string check_text(const Check& check);

}  // namespace mjcourse
