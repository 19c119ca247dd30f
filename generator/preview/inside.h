// Reading files for clients that ask over the network: only what lies inside of a folder.
// Tested by tests/generator/base/beneath_test.cpp.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace mjcourse {

// The bytes of the regular file `path`; nothing where there is none, or where it, or what a link
// makes of it, lies outside of `folder`.
std::optional<std::string> read_inside(const std::filesystem::path& folder,
                                       const std::filesystem::path& path);

}  // namespace mjcourse
