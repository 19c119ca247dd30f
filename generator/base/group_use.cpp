#include "base/group_use.h"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <utility>

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

class Counter {
 public:
  void add(const fs::path& process, std::uint64_t resident) {
    use_.memory += resident;
    std::error_code ended;
    for (fs::directory_iterator file(process / "fd", ended), end; !ended && file != end;
         file.increment(ended)) {
      add_file(file->path());
    }
  }
  GroupUse use() const { return use_; }

 private:
  void add_file(const fs::path& descriptor) {
    constexpr std::uint64_t block = 512;
    struct stat status {};
    if (stat(descriptor.c_str(), &status) != 0 || !S_ISREG(status.st_mode)) return;
    if (status.st_nlink > 0 || !seen_.emplace(status.st_dev, status.st_ino).second) return;
    use_.removed += static_cast<std::uint64_t>(status.st_blocks) * block;
  }

  GroupUse use_;
  std::set<std::pair<dev_t, ino_t>> seen_;
};

}  // namespace

GroupUse use_of_group(pid_t leader, bool alone) {
  Counter counter;
  if (alone) {
    const fs::path process = "/proc/" + std::to_string(leader);
    counter.add(process, state_of(process).resident);
    return counter.use();
  }
  std::error_code none;
  for (fs::directory_iterator process("/proc", none), end; !none && process != end;
       process.increment(none)) {
    const std::string name = process->path().filename().string();
    if (!std::all_of(name.begin(), name.end(), [](unsigned char c) { return std::isdigit(c); })) {
      continue;
    }
    const ProcessState state = state_of(process->path());
    if (state.group == leader) counter.add(process->path(), state.resident);
  }
  return counter.use();
}

}  // namespace mjcourse
