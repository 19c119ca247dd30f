// Snippets: the bodies of functions, all of a lesson's in one program.
//
// Steps: the program is made of one function for each, compiled with `#line` so that the compiler's
// complaints name the lesson. Then it is run once for each, from a fresh model and fresh data. So
// none sees what another did, and each has its output and its mistakes for itself.
// In the page, each is a program of its own (snippet_text.h).
#pragma once

#include <map>

#include "evaluate/context/worker_context.h"
#include "findings/result.h"

namespace mjcourse {

// What their program includes.
std::string snippets_prelude(const IncludeFolders& include);

// By their blocks; only of those that did what they should. A model that is wrong is not reported
// here.
std::map<std::size_t, ExampleResult> evaluate_snippets(const Lesson& lesson,
                                                       WorkerContext& worker_context,
                                                       Diagnostics& diagnostics);

// Is it likely that evaluate_snippets() compiles nothing?
bool are_known(const Lesson& lesson, WorkerContext& worker_context);

}  // namespace mjcourse
