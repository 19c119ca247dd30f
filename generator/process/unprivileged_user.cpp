#include "process/unprivileged_user.h"

#include <linux/capability.h>
#include <linux/securebits.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace mjcourse {
namespace {

constexpr unsigned kWords = _LINUX_CAPABILITY_U32S_3;

constexpr unsigned bit(int capability) {
  return 1u << (capability % 32);
}

// The kernel's own calls: the C library's would have all threads of its process do the same.
bool read_capabilities(__user_cap_data_struct (&sets)[kWords]) {
  __user_cap_header_struct header{_LINUX_CAPABILITY_VERSION_3, 0};
  return syscall(SYS_capget, &header, sets) == 0;
}

bool set_capabilities(unsigned effective, unsigned kept) {
  __user_cap_header_struct header{_LINUX_CAPABILITY_VERSION_3, 0};
  const __user_cap_data_struct sets[kWords]{{effective, effective, kept}};
  return syscall(SYS_capset, &header, sets) == 0;
}

// Gives up all others. Where even this one is not ours, only a course in a folder that is closed to
// others cannot be read.
bool keep_reading() {
  const unsigned reading = bit(CAP_DAC_READ_SEARCH);
  // access() answers as if a user had no capabilities, unless it is told that this one has.
  if (set_capabilities(reading | bit(CAP_SETPCAP), reading)) {
    prctl(PR_SET_SECUREBITS, SECBIT_NO_SETUID_FIXUP, 0, 0, 0);
  }
  if (!set_capabilities(reading, reading)) return set_capabilities(0, 0);
  prctl(PR_CAP_AMBIENT, PR_CAP_AMBIENT_RAISE, CAP_DAC_READ_SEARCH, 0, 0);
  return true;
}

}  // namespace

bool may_change_user() {
  __user_cap_data_struct sets[kWords]{};
  if (geteuid() != 0 || !read_capabilities(sets)) return false;
  const unsigned needed = bit(CAP_SETUID) | bit(CAP_SETGID) | bit(CAP_CHOWN) |
                          bit(CAP_DAC_OVERRIDE) | bit(CAP_FOWNER) | bit(CAP_KILL);
  return (sets[0].effective & needed) == needed;
}

bool become_user(uid_t id, bool read_all) {
  if (read_all && prctl(PR_SET_KEEPCAPS, 1, 0, 0, 0) != 0) return false;
  if (syscall(SYS_setgroups, 0, nullptr) != 0) return false;
  if (syscall(SYS_setresgid, id, id, id) != 0) return false;
  if (syscall(SYS_setresuid, id, id, id) != 0) return false;
  return !read_all || keep_reading();
}

}  // namespace mjcourse
