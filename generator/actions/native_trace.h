// What a compiled program depends on: the files that the compiler read, and those that the program
// opened.
// Tested by tests/store/dependencies.mjs.
#pragma once

#include <filesystem>

#include "cache/trace.h"
#include "process/subprocess.h"
#include "toolchain/compiler.h"
#include "toolchain/include_folders.h"

namespace mjcourse {

// The folder of `source` is where the compiler worked, `folder` where the program did; of these
// nothing is traced. `root` is the course's.
void trace_compilation(const Compiled& compiled, const std::filesystem::path& source,
                       const IncludeFolders& include, const std::filesystem::path& root,
                       Trace& trace);
void trace_run(const Outcome& outcome, const std::filesystem::path& folder,
               const std::filesystem::path& root, Trace& trace);

}  // namespace mjcourse
