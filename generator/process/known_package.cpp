#include "process/known_package.h"

#include <filesystem>

#include "process/subprocess.h"

namespace mjcourse {

std::string known_package(const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    Command command;
    command.arguments = {"apt-cache", "search", "--names-only", "^" + name + "$"};
    command.folder = std::filesystem::temp_directory_path();
    const Outcome outcome = run(command);
    if (outcome.end == Outcome::End::exited && !outcome.out.empty()) return name;
  }
  return names.front();
}

}  // namespace mjcourse
