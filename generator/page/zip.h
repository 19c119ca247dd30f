// Files as one zip archive whose bytes depend on nothing but the files: every date is zip's first.
#pragma once

#include <map>
#include <string>

namespace mjcourse {

// By their paths, in whose order they stand in the archive. Throws std::runtime_error.
std::string zip_of(const std::map<std::string, std::string>& files);

}  // namespace mjcourse
