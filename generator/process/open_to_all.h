// What a user who is nobody's can get at, by the modes of files alone.
#pragma once

#include <filesystem>

namespace mjcourse {

// Lets every folder above `path` everybody through?
bool can_be_reached_by_all(const std::filesystem::path& path);

// And may everybody read the file or folder, and all that is in there? What is not there is nothing
// to be read. A folder of very many files counts as one that not everybody may read.
bool can_be_read_by_all(const std::filesystem::path& path);

}  // namespace mjcourse
