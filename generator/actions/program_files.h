// The files that a program needs beside itself where somebody else builds it: headers of the
// course, handlers.cpp, and the models that it opened with all that these are made of.
// Tested by tests/site/programs-to-build.mjs.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "process/subprocess.h"
#include "toolchain/compiler.h"
#include "toolchain/include_folders.h"

namespace mjcourse {

// As ExampleResult has them. Headers that came with the tool stand where the course would have
// them. Where nobody knows what was opened, these are all models.
std::vector<std::string> program_files(const Compiled& compiled, const Outcome& outcome,
                                       const IncludeFolders& include,
                                       const std::filesystem::path& root);

}  // namespace mjcourse
