// What the compiler and the linker call themselves, without starting them each time.
//
// A tool says its version when it is first seen, and that is believed until its file changes.
// Tested by tests/generator/toolchain/compiler_test.cpp.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace mjcourse {

// The first line of what `tool --version` prints, `tool` being a name in PATH; nothing where there
// is no such program. What is found is noted in `cache`, where one is given.
std::optional<std::string> tool_version(const std::string& tool,
                                        const std::optional<std::filesystem::path>& cache);

}  // namespace mjcourse
