#include "process/group_use.h"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>

#include "base/utf8.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

struct ProcessState {
  pid_t group = -1;
  std::uint64_t resident = 0;  // bytes
};

// Of /proc/ID/stat, whose second field is the program's name in brackets, which may hold anything.
ProcessState state_of(const fs::path& process) {
  std::ifstream file(process / "stat");
  std::string text;
  std::getline(file, text, '\0');
  const std::size_t name_end = text.rfind(')');
  if (name_end == text.npos) return {};
  std::istringstream fields(text.substr(name_end + 1));
  constexpr int of_group = 5, of_resident = 24;
  ProcessState state;
  std::string field;
  for (int number = 3; number <= of_resident && fields >> field; ++number) {
    if (number == of_group) state.group = std::stoi(field);
    if (number == of_resident) {
      state.resident = std::stoull(field) * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
    }
  }
  return state;
}

struct Mapping {
  std::string range, path;  // "7f00-7f80", as the file in map_files/ is called, too
  ino_t file = 0;
};

// A line of /proc/ID/maps: "RANGE rwxp OFFSET DEVICE INODE   PATH (deleted)". Nothing where it is
// of no file that was removed.
std::optional<Mapping> removed_mapping(const std::string& line) {
  constexpr std::string_view mark = " (deleted)";
  if (!line.ends_with(mark)) return std::nullopt;
  Mapping mapping;
  std::string rights, offset, device;
  std::istringstream fields(line.substr(0, line.size() - mark.size()));
  fields >> mapping.range >> rights >> offset >> device >> mapping.file >> std::ws;
  std::getline(fields, mapping.path);
  return mapping;
}

class Counter {
 public:
  explicit Counter(const Sandbox& sandbox) : sandbox_(sandbox) {}

  void add(const fs::path& process, std::uint64_t resident) {
    use_.memory += resident;
    std::error_code ended;
    for (fs::directory_iterator file(process / "fd", ended), end; !ended && file != end;
         file.increment(ended)) {
      add_file(file->path());
    }
    std::ifstream mappings(process / "maps");
    for (std::string line; std::getline(mappings, line);) {
      const auto mapping = removed_mapping(line);
      if (mapping && is_its_own(mapping->path)) add_mapping(process, *mapping);
    }
  }
  GroupUse use() const { return use_; }

 private:
  void add_file(const fs::path& link) {
    struct stat status {};
    if (stat(link.c_str(), &status) == 0) add(status);
  }

  void add(const struct stat& status) {
    constexpr std::uint64_t block = 512;
    if (!S_ISREG(status.st_mode) || status.st_nlink > 0) return;
    if (!seen_.emplace(status.st_dev, status.st_ino).second) return;
    use_.removed += static_cast<std::uint64_t>(status.st_blocks) * block;
  }

  // Shared memory is mapped in the same way, and lies in no folder.
  bool is_its_own(const std::string& path) const {
    return std::ranges::any_of(sandbox_.write,
                               [&](const std::string& own) { return is_within(path, own); });
  }

  // Only root may look through a mapping at its file. To others one is as large as it may be, and
  // the number of its device need not be that which the file tells.
  void add_mapping(const fs::path& process, const Mapping& mapping) {
    struct stat status {};
    if (stat((process / "map_files" / mapping.range).c_str(), &status) == 0) {
      add(status);
    } else if (seen_.emplace(0, mapping.file).second) {
      use_.removed += sandbox_.file_bytes;
    }
  }

  const Sandbox& sandbox_;
  GroupUse use_;
  std::set<std::pair<dev_t, ino_t>> seen_;
};

}  // namespace

GroupUse use_of_group(pid_t leader, const Sandbox& sandbox) {
  Counter counter(sandbox);
  if (!sandbox.processes) {
    const fs::path process = "/proc/" + std::to_string(leader);
    counter.add(process, state_of(process).resident);
    return counter.use();
  }
  std::error_code none;
  for (fs::directory_iterator process("/proc", none), end; !none && process != end;
       process.increment(none)) {
    const std::string name = process->path().filename().string();
    if (!std::all_of(name.begin(), name.end(), is_digit)) {
      continue;
    }
    const ProcessState state = state_of(process->path());
    if (state.group == leader) counter.add(process->path(), state.resident);
  }
  return counter.use();
}

}  // namespace mjcourse
