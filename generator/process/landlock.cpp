#include "process/landlock.h"

#include <fcntl.h>
#include <linux/landlock.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

namespace mjcourse {
namespace {

using Rights = std::uint64_t;

// The ABI behind each is the first that has it.
constexpr Rights kExecute = 1 << 0, kWriteFile = 1 << 1, kReadFile = 1 << 2, kReadFolder = 1 << 3;
constexpr Rights kRemoveFolder = 1 << 4, kRemoveFile = 1 << 5, kMakeFolder = 1 << 7;
constexpr Rights kMakeFile = 1 << 8, kMakeLink = 1 << 12;
constexpr Rights kAllFirst = (1 << 13) - 1;
constexpr Rights kRefer = 1 << 13;                // 2: to rename from one folder to another
constexpr Rights kTruncate = 1 << 14;             // 3
constexpr std::uint64_t kBind = 1, kConnect = 2;  // 4: TCP
constexpr Rights kDeviceControl = 1 << 15;        // 5
constexpr std::uint64_t kSocketsAndSignals = 3;   // 6: only within what is confined together

struct RulesetAttributes {
  std::uint64_t files, network, scopes;
};

// A rule of connections, and its number.
struct PortAttributes {
  std::uint64_t rights, port;
};
constexpr int kPortRule = 2;

std::size_t size_of_attributes(int abi) {
  if (abi >= kLandlockScopes) return sizeof(RulesetAttributes);
  return abi >= kLandlockNetwork ? offsetof(RulesetAttributes, scopes)
                                 : offsetof(RulesetAttributes, network);
}

Rights handled(int abi) {
  Rights all = kAllFirst;
  if (abi >= 2) all |= kRefer;
  if (abi >= 3) all |= kTruncate;
  if (abi >= 5) all |= kDeviceControl;
  return all;
}

// Of a folder that may be changed. Nothing in it can be executed, or be a device or a socket.
constexpr Rights kChange = kReadFile | kReadFolder | kWriteFile | kTruncate | kRefer |
                           kRemoveFolder | kRemoveFile | kMakeFolder | kMakeFile | kMakeLink;
constexpr Rights kRead = kExecute | kReadFile | kReadFolder;
// Those that a file can have; the kernel minds others.
constexpr Rights kOfFile = kExecute | kWriteFile | kReadFile | kTruncate | kDeviceControl;

Rights rights_of(LandlockRule::Access access) {
  return access == LandlockRule::Access::write ? kChange : kRead;
}

bool add_rule(int ruleset, int abi, const LandlockRule& rule) {
  const int path = open(rule.path.c_str(), O_PATH | O_CLOEXEC);
  if (path < 0) return errno == ENOENT || errno == ENOTDIR || errno == EACCES;
  struct stat status {};
  bool added = fstat(path, &status) == 0;
  Rights rights = rights_of(rule.access) & handled(abi);
  if (!S_ISDIR(status.st_mode)) rights &= kOfFile;
  const landlock_path_beneath_attr beneath{rights, path};
  added = added &&
          syscall(SYS_landlock_add_rule, ruleset, LANDLOCK_RULE_PATH_BENEATH, &beneath, 0) == 0;
  close(path);
  return added;
}

}  // namespace

int landlock_abi() {
  const long abi =
      syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION);
  const int found = abi > 0 ? static_cast<int>(abi) : 0;
  const char* const lower = std::getenv("MJCOURSE_LANDLOCK");
  return lower == nullptr ? found : std::clamp(std::atoi(lower), 0, found);
}

int make_ruleset(int abi, const std::vector<LandlockRule>& rules,
                 const std::vector<std::uint16_t>& ports) {
  const RulesetAttributes attributes{handled(abi), kBind | kConnect, kSocketsAndSignals};
  const auto ruleset = static_cast<int>(
      syscall(SYS_landlock_create_ruleset, &attributes, size_of_attributes(abi), 0));
  if (ruleset < 0) return -1;
  for (const LandlockRule& rule : rules) {
    if (!add_rule(ruleset, abi, rule)) return -1;
  }
  for (const std::uint16_t port : ports) {
    const PortAttributes one{kConnect, port};
    if (abi >= kLandlockNetwork &&
        syscall(SYS_landlock_add_rule, ruleset, kPortRule, &one, 0) != 0) {
      return -1;
    }
  }
  return ruleset;
}

bool enter_ruleset(int ruleset) {
  const bool entered = syscall(SYS_landlock_restrict_self, ruleset, 0) == 0;
  close(ruleset);
  return entered;
}

}  // namespace mjcourse
