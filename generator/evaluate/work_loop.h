// What a worker does (worker.h): read a question from stdin, work on its task, write the answer to
// stdout; until stdin ends.
// Tested by tests/generator/evaluate/worker_test.cpp.
#pragma once

#include <filesystem>

#include "base/files.h"

namespace mjcourse {

// `root` is the course's folder, and `assets` has what the site's build made.
void answer_questions(const std::filesystem::path& root, const Files& assets);

}  // namespace mjcourse
