// ExerciseFiles: the texts of an exercise's programs, and what they are with another text in the
// region.
// Tested by tests/courses/exercise.
#pragma once

#include <optional>
#include <string>

#include "evaluate/context/worker_context.h"
#include "lesson/blocks/lesson.h"
#include "lesson/syntax/exercise_text.h"
#include "report/diagnostic.h"

namespace mjcourse {

// The text of an exercise's files, as they were read.
struct ExerciseFiles {
  ExerciseText text;
  std::optional<std::string> hidden;  // of the program with checks that no page shows
};

// Nothing (reported) where one of them cannot be read, or says nothing that can be understood.
std::optional<ExerciseFiles> read_exercise_files(const Exercise& exercise, const Lesson& lesson,
                                                 WorkerContext& worker_context,
                                                 Diagnostics& diagnostics);

// The program with the hidden checks of an exercise that has them, and its text with `code` in the
// region.
Example hidden_program(const Exercise& exercise);
std::string hidden_text(const Exercise& exercise, const ExerciseFiles& files,
                        const std::string& code);

}  // namespace mjcourse
