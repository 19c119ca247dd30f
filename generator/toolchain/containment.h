// What a lesson's programs may touch, the compiler that makes them, and the commands of a lesson.
//
// A program sees the course's models and a folder of its own, and writes into that folder and, for
// its lesson, into the file of its records. The compiler sees the course's examples and its own
// folder: whatever else a program includes is not there. Where one of these lies in a folder that
// is closed to others, and only there, a program that we run as root keeps root's right to read.
#pragma once

#include <filesystem>
#include <vector>

#include "process/sandbox.h"

namespace mjcourse {

// A file of the size at which a program is stopped has more records than are read.
inline constexpr std::uint64_t kMostProgramBytes = 32 << 20;

// `binary` runs in the folder `run`; both it and `records` exist. `records` may be empty: the
// program has no lesson to report to. `root` is the course's folder.
Sandbox program_sandbox(const std::filesystem::path& binary, const std::filesystem::path& run,
                        const std::filesystem::path& records, const std::filesystem::path& root);

// The compiler works in `folder`, where its source is; it may also read the `others`.
Sandbox compiler_sandbox(const std::filesystem::path& folder,
                         const std::vector<std::filesystem::path>& others);

// The package manager's list of what is installed.
inline constexpr const char* kInstalledPackages = "/var/lib/dpkg/status";

// Commands work in `folder`, may start what is installed, and find out what that is.
Sandbox commands_sandbox(const std::filesystem::path& script, const std::filesystem::path& folder);

}  // namespace mjcourse
