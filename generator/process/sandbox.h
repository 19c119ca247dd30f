// What a program may do that somebody else wrote, and how much of that this machine can enforce.
//
// A Sandbox is a policy; run() of subprocess.h enforces it with all that the kernel has: resource
// limits, no_new_privs, a system call filter, Landlock, and, when we are root, a user of its own.
// Where a layer is missing, the others still hold; sandbox_level() says which there are.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace mjcourse {

// Beside what it names, a program reads the system's libraries and headers, and no settings.
struct Sandbox {
  std::vector<std::string> read;   // files and folders it may read and execute
  std::vector<std::string> write;  // files and folders it may change; must exist, and be ours
  // May it, as the unprivileged user that it becomes where we are root, read what its mode keeps
  // from that user? It then does so in the system's folders too, so only a run that cannot do
  // without is given it.
  bool reads_all = false;
  bool processes = false;  // may it start others, as a compiler does? Threads it always may
  // May it ask others on the network? It listens nowhere, and has no socket within this machine.
  // TCP goes to `ports` alone, of any machine, where Landlock knows how.
  bool network = false;
  std::vector<std::uint16_t> ports = {};
  bool narrows = false;  // may it give up more system calls by itself?
  // Of address space, of one process; and of memory, of all that it starts together.
  std::uint64_t memory_bytes = 4ull << 30;
  // Does it reserve address space that it never uses, as a script engine does? Then only the second
  // counts, and it must be one that may start others.
  bool reserves = false;
  std::uint64_t file_bytes = 32 << 20;  // of one file
  // Of all that lies in `write`, and of what was removed from there and is still open
  // or mapped.
  std::uint64_t folder_bytes = 128 << 20;
  std::uint64_t folder_entries = 10'000;  // files and folders in there
  std::uint64_t open_files = 64;
};

// Threads of a program that is watched.
inline constexpr int kMostThreads = 256;

struct SandboxLevel {
  bool filter = false;  // seccomp
  bool watch = false;   // seccomp's user notification: somebody is asked about each file
  int landlock = 0;     // its ABI; 0 for none
  enum class User { same, own, nobody };
  User user = User::same;

  // The unprivileged id for the process `pid`; nothing where we are no root to change it.
  std::optional<uid_t> user_for(pid_t pid) const;
  // "rlimits, no_new_privs, seccomp, Landlock 7, a user id for each run"
  std::string text() const;
  // What the newest kernels would hold and this one does not, as "no Landlock, ..."; empty where it
  // holds all.
  std::string weakness() const;
};

// Found out by trying, once in a process.
const SandboxLevel& sandbox_level();

// What every program may read of the system, and what it may write of it.
const std::vector<std::string>& readable_system_paths();
const std::vector<std::string>& writable_system_paths();

// Is `path` the folder or file `folder`, or does it lie in there? Both are absolute and normal.
bool is_within(std::string_view path, std::string_view folder);

}  // namespace mjcourse
