#include "base/syscall_filter.h"

#include <linux/sched.h>
#include <linux/seccomp.h>
#include <seccomp.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <memory>
#include <mutex>
#include <optional>
#include <system_error>

#include "base/path_calls.h"

namespace mjcourse {
namespace {

// Denied to whoever is confined, without a word: they fail as for want of a privilege.
const int kDenied[] = {
    // other processes
    SCMP_SYS(ptrace), SCMP_SYS(process_vm_readv), SCMP_SYS(process_vm_writev), SCMP_SYS(kcmp),
    SCMP_SYS(pidfd_open), SCMP_SYS(pidfd_getfd), SCMP_SYS(pidfd_send_signal),
    SCMP_SYS(process_madvise), SCMP_SYS(process_mrelease), SCMP_SYS(move_pages),
    SCMP_SYS(migrate_pages), SCMP_SYS(setpriority), SCMP_SYS(ioprio_set),
    // out of the process group, which is how everything is found again that is to be ended
    SCMP_SYS(setsid), SCMP_SYS(setpgid),
    // mounts, namespaces, other roots
    SCMP_SYS(mount), SCMP_SYS(umount2), SCMP_SYS(pivot_root), SCMP_SYS(chroot),
    SCMP_SYS(move_mount), SCMP_SYS(open_tree), SCMP_SYS(fsopen), SCMP_SYS(fsconfig),
    SCMP_SYS(fsmount), SCMP_SYS(fspick), SCMP_SYS(mount_setattr), SCMP_SYS(unshare),
    SCMP_SYS(setns),
    // the kernel's own
    SCMP_SYS(bpf), SCMP_SYS(perf_event_open), SCMP_SYS(userfaultfd), SCMP_SYS(io_uring_setup),
    SCMP_SYS(io_uring_enter), SCMP_SYS(io_uring_register), SCMP_SYS(add_key), SCMP_SYS(request_key),
    SCMP_SYS(keyctl), SCMP_SYS(kexec_load), SCMP_SYS(kexec_file_load), SCMP_SYS(init_module),
    SCMP_SYS(finit_module), SCMP_SYS(delete_module), SCMP_SYS(reboot), SCMP_SYS(swapon),
    SCMP_SYS(swapoff), SCMP_SYS(acct), SCMP_SYS(quotactl), SCMP_SYS(syslog), SCMP_SYS(settimeofday),
    SCMP_SYS(clock_settime), SCMP_SYS(clock_adjtime), SCMP_SYS(adjtimex), SCMP_SYS(sethostname),
    SCMP_SYS(setdomainname), SCMP_SYS(iopl), SCMP_SYS(ioperm), SCMP_SYS(vhangup),
    SCMP_SYS(lookup_dcookie), SCMP_SYS(fanotify_init), SCMP_SYS(personality), SCMP_SYS(seccomp),
    // files past their path
    SCMP_SYS(name_to_handle_at), SCMP_SYS(open_by_handle_at),
    // what outlives its process, or is memory that no limit counts
    SCMP_SYS(memfd_create), SCMP_SYS(memfd_secret), SCMP_SYS(shmget), SCMP_SYS(semget),
    SCMP_SYS(msgget), SCMP_SYS(mq_open)};

// What Landlock does not look at: modes, owners, times and attributes of files that can be seen.
// A compiler's linker makes its program executable.
const int kDeniedToPrograms[] = {
    SCMP_SYS(chmod),     SCMP_SYS(fchmodat),    SCMP_SYS(chown),        SCMP_SYS(lchown),
    SCMP_SYS(fchown),    SCMP_SYS(fchownat),    SCMP_SYS(utime),        SCMP_SYS(utimes),
    SCMP_SYS(utimensat), SCMP_SYS(futimesat),   SCMP_SYS(setxattr),     SCMP_SYS(lsetxattr),
    SCMP_SYS(fsetxattr), SCMP_SYS(removexattr), SCMP_SYS(lremovexattr), SCMP_SYS(fremovexattr)};

// The watcher, who knows the program's own process, decides.
const int kSignals[] = {SCMP_SYS(kill), SCMP_SYS(tkill), SCMP_SYS(tgkill),
                        SCMP_SYS(rt_sigqueueinfo), SCMP_SYS(rt_tgsigqueueinfo)};

constexpr std::uint32_t kGuardedOptions[] = {PR_SET_PDEATHSIG, PR_SET_DUMPABLE, PR_SET_SECCOMP};
constexpr std::uint32_t kTerminalRequests[] = {0x5412, 0x541C};  // TIOCSTI, TIOCLINUX

// A condition on an argument of a system call. (libseccomp's own macros are C's compound literals.)
scmp_arg_cmp argument(unsigned number, scmp_compare compare, scmp_datum_t a, scmp_datum_t b = 0) {
  return {number, compare, a, b};
}

class Builder {
 public:
  explicit Builder(FilterKind kind) : kind_(kind), context_(seccomp_init(SCMP_ACT_ALLOW)) {
    if (context_ == nullptr) throw std::system_error(ENOMEM, std::generic_category(), "seccomp");
    // The same calls by their numbers of another architecture.
    seccomp_attr_set(context_.get(), SCMP_FLTATR_ACT_BADARCH, SCMP_ACT_KILL_PROCESS);
    seccomp_attr_set(context_.get(), SCMP_FLTATR_CTL_OPTIMIZE, 2);
  }

  SyscallFilter build() {
    if (kind_.confine) confine();
    if (kind_.confine && !kind_.processes) confine_to_one_process();
    if (kind_.watch) watch();
    return program();
  }

 private:
  template <typename... Comparisons>
  void add(std::uint32_t action, int call, Comparisons... comparisons) {
    const int failure =
        seccomp_rule_add(context_.get(), action, call, sizeof...(comparisons), comparisons...);
    // EEXIST: it is in there; EDOM: this machine does not have the call.
    if (failure != 0 && failure != -EEXIST && failure != -EDOM) {
      throw std::system_error(-failure, std::generic_category(), "seccomp_rule_add");
    }
  }

  void deny(int call) { add(SCMP_ACT_ERRNO(EPERM), call); }

  // What a watcher should hear of, so that an author does; without one, it fails.
  std::uint32_t told() const { return kind_.watch ? SCMP_ACT_NOTIFY : SCMP_ACT_ERRNO(EPERM); }

  void confine() {
    const std::uint32_t no = SCMP_ACT_ERRNO(EPERM);
    for (const int call : kDenied) deny(call);
    // Its flags lie in memory, where no filter sees them; without it the C library takes clone.
    add(SCMP_ACT_ERRNO(ENOSYS), SCMP_SYS(clone3));
    for (const std::uint32_t option : kGuardedOptions) {
      add(no, SCMP_SYS(prctl), argument(0, SCMP_CMP_EQ, option));
    }
    for (const std::uint32_t request : kTerminalRequests) {
      add(no, SCMP_SYS(ioctl), argument(1, SCMP_CMP_EQ, request));
    }
    add(no, SCMP_SYS(prlimit64), argument(0, SCMP_CMP_NE, 0));
    add(no, SCMP_SYS(socketpair), argument(0, SCMP_CMP_NE, AF_UNIX));
    // The C library asks its name service over a local socket, and does well without.
    add(no, SCMP_SYS(socket), argument(0, SCMP_CMP_EQ, AF_UNIX));
    add(told(), SCMP_SYS(socket), argument(0, SCMP_CMP_NE, AF_UNIX));
    if (kind_.processes) {
      // Where Landlock does not see to it, a signal may reach whoever is of the same user.
      deny(SCMP_SYS(kill));
      for (const auto flag : {CLONE_NEWNS, CLONE_NEWUTS, CLONE_NEWIPC, CLONE_NEWUSER, CLONE_NEWPID,
                              CLONE_NEWNET, CLONE_NEWCGROUP, CLONE_PARENT}) {
        const auto bit = static_cast<scmp_datum_t>(flag);
        add(no, SCMP_SYS(clone), argument(0, SCMP_CMP_MASKED_EQ, bit, bit));
      }
    }
  }

  void confine_to_one_process() {
    for (const int call : kDeniedToPrograms) deny(call);
    add(told(), SCMP_SYS(fork));
    add(told(), SCMP_SYS(vfork));
    if (kind_.watch) {
      add(SCMP_ACT_NOTIFY, SCMP_SYS(clone));
      add(SCMP_ACT_NOTIFY, SCMP_SYS(execve));
      add(SCMP_ACT_NOTIFY, SCMP_SYS(execveat));
      add(SCMP_ACT_NOTIFY, SCMP_SYS(fchmod));
      for (const int call : kSignals) add(SCMP_ACT_NOTIFY, call);
    } else {
      add(SCMP_ACT_ERRNO(EPERM), SCMP_SYS(clone), argument(0, SCMP_CMP_MASKED_EQ, CLONE_THREAD, 0));
      deny(SCMP_SYS(kill));  // abort() sends its signal by tgkill
    }
  }

  void watch() {
    for (const PathCall& call : path_calls()) add(SCMP_ACT_NOTIFY, call.number);
  }

  SyscallFilter program() const {
    const int file = memfd_create("filter", MFD_CLOEXEC);
    const int failure = seccomp_export_bpf(context_.get(), file);
    SyscallFilter filter;
    std::array<sock_filter, 64> part;
    lseek(file, 0, SEEK_SET);
    for (ssize_t n = 0; (n = read(file, part.data(), sizeof part)) > 0;) {
      filter.insert(filter.end(), part.begin(),
                    part.begin() + n / static_cast<ssize_t>(sizeof(sock_filter)));
    }
    close(file);
    if (failure != 0 || filter.empty()) {
      throw std::system_error(EINVAL, std::generic_category(), "seccomp_export_bpf");
    }
    return filter;
  }

  struct Release {
    void operator()(void* context) const { seccomp_release(context); }
  };
  FilterKind kind_;
  std::unique_ptr<void, Release> context_;
};

long enter(const SyscallFilter& filter, unsigned long flags) {
  const sock_fprog program{static_cast<unsigned short>(filter.size()),
                           const_cast<sock_filter*>(filter.data())};
  return syscall(SYS_seccomp, SECCOMP_SET_MODE_FILTER, flags, &program);
}

}  // namespace

bool can_watch() {
  constexpr unsigned with_notification = 5;  // of libseccomp's levels
  return seccomp_api_get() >= with_notification;
}

const SyscallFilter& syscall_filter(FilterKind kind) {
  static std::mutex mutex;
  static std::array<std::optional<SyscallFilter>, 8> made;
  const std::lock_guard lock(mutex);
  auto& filter =
      made[(kind.confine ? 1u : 0u) + (kind.processes ? 2u : 0u) + (kind.watch ? 4u : 0u)];
  if (!filter) filter = Builder(kind).build();
  return *filter;
}

bool enter_filter(const SyscallFilter& filter) {
  return enter(filter, SECCOMP_FILTER_FLAG_SPEC_ALLOW) == 0;
}

int enter_filter_with_listener(const SyscallFilter& filter) {
  const unsigned long flags = SECCOMP_FILTER_FLAG_SPEC_ALLOW | SECCOMP_FILTER_FLAG_NEW_LISTENER;
  // Where the kernel can: a signal does not undo a question that was put.
  long listener = enter(filter, flags | SECCOMP_FILTER_FLAG_WAIT_KILLABLE_RECV);
  if (listener < 0 && errno == EINVAL) listener = enter(filter, flags);
  return static_cast<int>(listener);
}

}  // namespace mjcourse
