// What lets a reader edit and run a program in the page: the data of its listing that the page's
// script (site/browser/client/programs.ts) finds.
// Tested by tests/generator/page/blocks/page_writer_test.cpp.
#pragma once

#include <cstddef>
#include <set>
#include <string>

#include "base/files.h"
#include "findings/evaluation.h"
#include "page/blocks/lesson_context.h"

namespace mjcourse {

// As example.hbs calls it; null for a program that no page runs, and where the site has no
// compiler.
nlohmann::json run_data(const Example& example, const ExampleResult* result,
                        const LessonContext& context);

// Of an exercise, whose reader begins with its starter.
nlohmann::json run_data(const Exercise& exercise, const ExerciseResult& result,
                        const LessonContext& context);

// For a lab, whose state its reader may open as a program: those of the data that the lab does not
// have itself, as JSON; "" where the lesson has no program that runs in the page.
std::string lab_compiler(const LessonContext& context);

// Why no page runs the program, in a clause; null where one does, or nobody tried.
nlohmann::json why_not_data(const ExampleResult* result);
nlohmann::json why_not_data(const ExerciseResult& result);

// The assets that a site does not need whose readers run no program: the compiler is larger than
// all else. By their paths in the site.
std::set<std::string> unused_assets(const Evaluation& evaluation, const Files& assets);

// Of all that a reader fetches once to run a program; 0 where the site has no compiler.
std::size_t compiler_bytes(const Files& assets, const nlohmann::json& manifest);

}  // namespace mjcourse
