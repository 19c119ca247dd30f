#include "process/machine_memory.h"

#include <algorithm>
#include <fstream>
#include <sstream>
#include <string>
#include <string_view>

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kNoLimit = UINT64_MAX;

// Of a group's file, which holds a number or "max".
std::uint64_t limit_in(const fs::path& file) {
  std::ifstream text(file);
  std::uint64_t limit = kNoLimit;
  return text >> limit ? limit : kNoLimit;
}

// Of the group `name` in the hierarchy at `mount`, and of all that it lies in. What a container
// does not see of them is not there.
std::uint64_t limit_of_group(const fs::path& mount, fs::path name, const char* file) {
  std::uint64_t limit = limit_in(mount / file);
  for (; name.has_relative_path(); name = name.parent_path()) {
    limit = std::min(limit, limit_in(mount / name.relative_path() / file));
  }
  return limit;
}

std::uint64_t limit_of_groups(const fs::path& root) {
  const fs::path mount = root / "sys/fs/cgroup";
  std::ifstream groups(root / "proc/self/cgroup");
  std::uint64_t limit = kNoLimit;
  std::string number, controllers, name;
  // "4:memory:/NAME", or "0::/NAME" of the second version.
  while (std::getline(groups, number, ':') && std::getline(groups, controllers, ':') &&
         std::getline(groups, name)) {
    if (controllers.empty()) {
      limit = std::min(limit, limit_of_group(mount, name, "memory.max"));
    } else if (("," + controllers + ",").find(",memory,") != std::string::npos) {
      limit = std::min(limit, limit_of_group(mount / "memory", name, "memory.limit_in_bytes"));
    }
  }
  return limit;
}

}  // namespace

std::uint64_t machine_memory(const fs::path& root) {
  constexpr std::uint64_t kilobyte = 1024;
  constexpr std::string_view total = "MemTotal:";
  std::uint64_t memory = kNoLimit;
  std::ifstream lines(root / "proc/meminfo");
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with(total)) continue;
    std::istringstream number(line.substr(total.size()));
    std::uint64_t kilobytes = 0;
    if (number >> kilobytes) memory = kilobytes * kilobyte;
  }
  return std::min(memory, limit_of_groups(root));
}

}  // namespace mjcourse
