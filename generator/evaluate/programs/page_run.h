// A program's second run: compiled and run as a reader's page does it.
//
// The process of the page's compiler (toolchain/page_process.h) gets the files that the reader
// takes along, under their names there. What it answers is held against the native run here, but
// for the output, of which the lesson may say more (page_output.h).
#pragma once

#include <optional>
#include <string>

#include "evaluate/context/worker_context.h"
#include "findings/result.h"
#include "lesson/blocks/block.h"

namespace mjcourse {

// How a PageRun says why a program that the page's compiler refuses does not run there.
inline constexpr const char* kPageRefuses = "the page's compiler says: ";

// `code` is all of the program, and `native` what came of its first run. Nothing where the build
// has no compiler of a page.
std::optional<PageRun> run_in_page(const Example& example, const std::string& code,
                                   const ExampleResult& native, WorkerContext& worker_context);

}  // namespace mjcourse
