// Where a course's programs find headers: in its own examples/include, and the helper header, where
// the course has none, in the folder that came with the tool. The helper header and its
// handlers.cpp come from one folder, as they belong together.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace mjcourse {

inline constexpr const char* kHelperHeader = "mjcourse/mjcourse.hpp";

// In the order in which the compiler looks; the first is the course's own, there or not.
using IncludeFolders = std::vector<std::filesystem::path>;

// Of a course with these `examples`; `helper` is the tool's folder, or empty.
IncludeFolders include_folders_of(const std::filesystem::path& examples,
                                  const std::filesystem::path& helper);

// The first folder that has the file `name`; empty where none has.
std::filesystem::path folder_with(const std::string& name, const IncludeFolders& folders);

// handlers.cpp beside the helper header; empty where there is none.
std::filesystem::path handlers_source(const IncludeFolders& folders);

// What a compiler reads that looks there: of a course all of its examples.
std::vector<std::filesystem::path> read_for(const IncludeFolders& folders);

}  // namespace mjcourse
