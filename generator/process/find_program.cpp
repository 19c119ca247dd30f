#include "process/find_program.h"

#include <unistd.h>

#include <cstdlib>
#include <sstream>

namespace mjcourse {

std::filesystem::path find_program(const std::string& name) {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "" : path);
  for (std::string folder; std::getline(folders, folder, ':');) {
    std::filesystem::path found = std::filesystem::path(folder) / name;
    // A folder that may be entered is no program.
    std::error_code none;
    const bool is_file = std::filesystem::is_regular_file(found, none);
    if (is_file && access(found.c_str(), X_OK) == 0) return found;
  }
  return {};
}

}  // namespace mjcourse
