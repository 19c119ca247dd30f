#include "process/path_calls.h"

#include <seccomp.h>

namespace mjcourse {
std::span<const PathCall> path_calls() {
  using enum FileAccess;
  static const PathCall calls[] = {
      {SCMP_SYS(open), -1, 0, by_flags, 1},
      {SCMP_SYS(openat), 0, 1, by_flags, 2},
      {SCMP_SYS(openat2), 0, 1, by_struct, 2},
      {SCMP_SYS(creat), -1, 0, write},

      {SCMP_SYS(stat), -1, 0, look},
      {SCMP_SYS(lstat), -1, 0, look},
      {SCMP_SYS(newfstatat), 0, 1, look},
      {SCMP_SYS(statx), 0, 1, look},
      {SCMP_SYS(access), -1, 0, look},
      {SCMP_SYS(faccessat), 0, 1, look},
      {SCMP_SYS(faccessat2), 0, 1, look},
      {SCMP_SYS(readlink), -1, 0, look},
      {SCMP_SYS(readlinkat), 0, 1, look},
      {SCMP_SYS(getxattr), -1, 0, look},
      {SCMP_SYS(lgetxattr), -1, 0, look},
      {SCMP_SYS(chdir), -1, 0, look},
      {SCMP_SYS(inotify_add_watch), -1, 1, look},

      {SCMP_SYS(mkdir), -1, 0, write},
      {SCMP_SYS(mkdirat), 0, 1, write},
      {SCMP_SYS(mknod), -1, 0, write},
      {SCMP_SYS(mknodat), 0, 1, write},
      {SCMP_SYS(unlink), -1, 0, write},
      {SCMP_SYS(unlinkat), 0, 1, write},
      {SCMP_SYS(rmdir), -1, 0, write},
      {SCMP_SYS(rename), -1, 0, write},
      {SCMP_SYS(rename), -1, 1, write},
      {SCMP_SYS(renameat), 0, 1, write},
      {SCMP_SYS(renameat), 2, 3, write},
      {SCMP_SYS(renameat2), 0, 1, write},
      {SCMP_SYS(renameat2), 2, 3, write},
      {SCMP_SYS(link), -1, 0, read},
      {SCMP_SYS(link), -1, 1, write},
      {SCMP_SYS(linkat), 0, 1, read},
      {SCMP_SYS(linkat), 2, 3, write},
      {SCMP_SYS(symlink), -1, 1, write},
      {SCMP_SYS(symlinkat), 1, 2, write},
      {SCMP_SYS(truncate), -1, 0, write},
  };
  return calls;
}

}  // namespace mjcourse
