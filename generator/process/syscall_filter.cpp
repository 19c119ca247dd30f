#include "process/syscall_filter.h"

#include <fcntl.h>
#include <linux/sched.h>
#include <linux/seccomp.h>
#include <netinet/in.h>
#include <seccomp.h>
#include <sys/ioctl.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstddef>
#include <iterator>
#include <memory>
#include <mutex>
#include <optional>
#include <system_error>
#include <utility>

#include "base/descriptor.h"
#include "process/path_calls.h"

namespace mjcourse {
namespace {

// Denied to every confined program, without a word: they fail as for want of a privilege.
const int kDenied[] = {
    // other processes
    SCMP_SYS(ptrace), SCMP_SYS(process_vm_readv), SCMP_SYS(process_vm_writev), SCMP_SYS(kcmp),
    SCMP_SYS(pidfd_open), SCMP_SYS(pidfd_getfd), SCMP_SYS(pidfd_send_signal),
    SCMP_SYS(process_madvise), SCMP_SYS(process_mrelease), SCMP_SYS(move_pages),
    SCMP_SYS(migrate_pages), SCMP_SYS(setpriority), SCMP_SYS(ioprio_set), SCMP_SYS(get_robust_list),
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
    SCMP_SYS(swapoff), SCMP_SYS(acct), SCMP_SYS(quotactl), SCMP_SYS(quotactl_fd), SCMP_SYS(syslog),
    SCMP_SYS(settimeofday), SCMP_SYS(clock_settime), SCMP_SYS(clock_adjtime), SCMP_SYS(adjtimex),
    SCMP_SYS(sethostname), SCMP_SYS(setdomainname), SCMP_SYS(iopl), SCMP_SYS(ioperm),
    SCMP_SYS(vhangup), SCMP_SYS(lookup_dcookie), SCMP_SYS(fanotify_init), SCMP_SYS(personality),
    // files past their path, and what others do with files, which Landlock does not keep secret
    SCMP_SYS(name_to_handle_at), SCMP_SYS(open_by_handle_at), SCMP_SYS(inotify_init),
    SCMP_SYS(inotify_init1), SCMP_SYS(inotify_add_watch), SCMP_SYS(fanotify_mark),
    // owners and attributes of files, at which Landlock does not look
    SCMP_SYS(chown), SCMP_SYS(lchown), SCMP_SYS(fchown), SCMP_SYS(fchownat), SCMP_SYS(setxattr),
    SCMP_SYS(lsetxattr), SCMP_SYS(fsetxattr), SCMP_SYS(removexattr), SCMP_SYS(lremovexattr),
    SCMP_SYS(fremovexattr),
    // times in the ways of old; the C library takes utimensat
    SCMP_SYS(utime), SCMP_SYS(utimes), SCMP_SYS(futimesat),
    // what outlives its process, belongs to another of its user, or is memory that no limit counts
    SCMP_SYS(memfd_create), SCMP_SYS(memfd_secret), SCMP_SYS(shmget), SCMP_SYS(shmat),
    SCMP_SYS(shmctl), SCMP_SYS(semget), SCMP_SYS(semop), SCMP_SYS(semtimedop), SCMP_SYS(semctl),
    SCMP_SYS(msgget), SCMP_SYS(msgsnd), SCMP_SYS(msgrcv), SCMP_SYS(msgctl), SCMP_SYS(mq_open),
    SCMP_SYS(mq_unlink)};

// As on a file system that has none of it. Landlock does not keep secret what else of a file is
// kept with it; and room for a file that nobody writes costs no time, so a disk would be full
// before anybody looks. The C library writes where there is no fallocate.
const int kUnsupported[] = {SCMP_SYS(getxattr),  SCMP_SYS(lgetxattr),  SCMP_SYS(fgetxattr),
                            SCMP_SYS(listxattr), SCMP_SYS(llistxattr), SCMP_SYS(flistxattr),
                            SCMP_SYS(fallocate)};

// The newest call that was there when the lists were written: set_mempolicy_home_node. From 424 on
// a call has one number on all architectures.
constexpr std::uint32_t kNewestCall = 450;
// From here on, x86 has its calls for 32-bit addresses, which end the program.
constexpr std::uint32_t kOtherNumbers = 0x40000000;

// Modes and times of files, at which Landlock does not look, and lengths, at which it does from its
// third ABI on: the watcher makes the change, for files of the program's own. A compiler's linker
// makes its program executable.
const int kFileChanges[] = {SCMP_SYS(chmod), SCMP_SYS(fchmod), SCMP_SYS(fchmodat),
                            SCMP_SYS(utimensat), SCMP_SYS(truncate)};

// The watcher, who knows the program's own process, decides.
const int kSignals[] = {SCMP_SYS(tkill), SCMP_SYS(tgkill), SCMP_SYS(rt_sigqueueinfo),
                        SCMP_SYS(rt_tgsigqueueinfo)};

// Of a process, or of the caller, where it is 0.
const int kScheduling[] = {SCMP_SYS(sched_setaffinity), SCMP_SYS(sched_setscheduler),
                           SCMP_SYS(sched_setparam), SCMP_SYS(sched_setattr)};

constexpr std::uint32_t kGuardedOptions[] = {PR_SET_PDEATHSIG, PR_SET_DUMPABLE, PR_SET_SECCOMP};
// TIOCSTI and TIOCLINUX; and whom the kernel sends a signal when a descriptor is ready: FIOSETOWN
// and SIOCSPGRP, as F_SETOWN does.
constexpr std::uint32_t kGuardedRequests[] = {0x5412, 0x541C, 0x8901, 0x8902};
// F_SETOWN and its like; and leases, for whose end everybody waits who opens the file, and what
// tells of others' files.
constexpr std::uint32_t kGuardedCommands[] = {F_SETOWN, F_SETSIG, F_SETOWN_EX, F_SETLEASE,
                                              F_NOTIFY};

// Of a program that asks others and is asked by nobody.
const int kServing[] = {SCMP_SYS(bind), SCMP_SYS(listen), SCMP_SYS(accept), SCMP_SYS(accept4)};
// All protocols but those of the system's choice, TCP and UDP: Landlock knows TCP alone.
constexpr scmp_datum_t kLastProtocol = IPPROTO_UDP;
// The kinds of sockets, in an argument that has flags as well.
constexpr scmp_datum_t kSocketKinds = 0xf;

// A condition on an argument of a system call. (libseccomp's own macros are C's compound literals.)
scmp_arg_cmp argument(unsigned number, scmp_compare compare, scmp_datum_t a, scmp_datum_t b = 0) {
  return {number, compare, a, b};
}

// The kernel takes half of what a register holds for such an argument.
scmp_arg_cmp argument_is(unsigned number, std::uint32_t value) {
  return argument(number, SCMP_CMP_MASKED_EQ, 0xFFFFFFFF, value);
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
  // What a watcher decides; without one, it fails.
  std::uint32_t asked() const { return kind_.asked ? SCMP_ACT_NOTIFY : SCMP_ACT_ERRNO(EPERM); }

  void confine() {
    const std::uint32_t no = SCMP_ACT_ERRNO(EPERM);
    for (const int call : kDenied) deny(call);
    for (const int call : kUnsupported) add(SCMP_ACT_ERRNO(EOPNOTSUPP), call);
    // Their flags lie in memory, where no filter sees them; without clone3 the C library takes
    // clone.
    for (const int call : {SCMP_SYS(clone3), SCMP_SYS(openat2)}) add(SCMP_ACT_ERRNO(ENOSYS), call);
    for (const std::uint32_t option : kGuardedOptions) {
      add(no, SCMP_SYS(prctl), argument_is(0, option));
    }
    for (const std::uint32_t request : kGuardedRequests) {
      add(no, SCMP_SYS(ioctl), argument_is(1, request));
    }
    for (const std::uint32_t command : kGuardedCommands) {
      add(no, SCMP_SYS(fcntl), argument_is(1, command));
    }
    for (const int call : kScheduling) add(asked(), call, argument(0, SCMP_CMP_NE, 0));
    add(no, SCMP_SYS(prlimit64), argument(0, SCMP_CMP_NE, 0));
    decide_on_filters();
    decide_on_sockets();
    if (kind_.processes) {
      // Where Landlock does not see to it, a signal may reach any process of the same user.
      deny(SCMP_SYS(kill));
      if (!kind_.scoped) decide_on_signals();
      // Without a watcher, the linker must be able to.
      if (kind_.asked) decide_on_file_changes();
      for (const auto flag : {CLONE_NEWNS, CLONE_NEWUTS, CLONE_NEWIPC, CLONE_NEWUSER, CLONE_NEWPID,
                              CLONE_NEWNET, CLONE_NEWCGROUP, CLONE_PARENT}) {
        const auto bit = static_cast<scmp_datum_t>(flag);
        add(no, SCMP_SYS(clone), argument(0, SCMP_CMP_MASKED_EQ, bit, bit));
      }
    }
  }

  // One of its own can only forbid more, and must not bring a watcher.
  void decide_on_filters() {
    if (!kind_.narrows) return deny(SCMP_SYS(seccomp));
    const std::uint32_t no = SCMP_ACT_ERRNO(EPERM);
    add(no, SCMP_SYS(seccomp), argument(0, SCMP_CMP_NE, SECCOMP_SET_MODE_FILTER));
    add(no, SCMP_SYS(seccomp), argument(1, SCMP_CMP_NE, 0));
  }

  void decide_on_sockets() {
    const std::uint32_t no = SCMP_ACT_ERRNO(EPERM);
    // Files that lie in a socket, on their way, are counted by nobody: one that writes none may.
    if (kind_.processes || kind_.network) {
      add(no, SCMP_SYS(socketpair), argument(0, SCMP_CMP_NE, AF_UNIX));
    } else {
      deny(SCMP_SYS(socketpair));
    }
    if (kind_.network) return decide_on_network();
    // The C library asks its name service over a local socket, and does well without.
    add(no, SCMP_SYS(socket), argument(0, SCMP_CMP_EQ, AF_UNIX));
    add(told(), SCMP_SYS(socket), argument(0, SCMP_CMP_NE, AF_UNIX));
  }

  // TCP and UDP by IP, from here to others. A rule has one condition of an argument.
  void decide_on_network() {
    const std::uint32_t no = SCMP_ACT_ERRNO(EPERM);
    for (const int call : kServing) deny(call);
    for (scmp_datum_t family = 0; family < AF_INET6; ++family) {
      if (family != AF_INET) add(no, SCMP_SYS(socket), argument(0, SCMP_CMP_EQ, family));
    }
    add(no, SCMP_SYS(socket), argument(0, SCMP_CMP_GT, AF_INET6));
    for (scmp_datum_t kind = 0; kind <= kSocketKinds; ++kind) {
      if (kind == SOCK_STREAM || kind == SOCK_DGRAM) continue;
      add(no, SCMP_SYS(socket), argument(1, SCMP_CMP_MASKED_EQ, kSocketKinds, kind));
    }
    for (scmp_datum_t protocol = 1; protocol < kLastProtocol; ++protocol) {
      if (protocol != IPPROTO_TCP) add(no, SCMP_SYS(socket), argument(2, SCMP_CMP_EQ, protocol));
    }
    add(no, SCMP_SYS(socket), argument(2, SCMP_CMP_GT, kLastProtocol));
    // What is sent with the connection itself is sent without asking Landlock.
    const auto flag = static_cast<scmp_datum_t>(MSG_FASTOPEN);
    for (const auto& [call, flags] :
         {std::pair{SCMP_SYS(sendto), 3u}, {SCMP_SYS(sendmsg), 2u}, {SCMP_SYS(sendmmsg), 3u}}) {
      add(no, call, argument(flags, SCMP_CMP_MASKED_EQ, flag, flag));
    }
  }

  void confine_to_one_process() {
    decide_on_file_changes();
    add(told(), SCMP_SYS(fork));
    add(told(), SCMP_SYS(vfork));
    if (kind_.watch) {
      add(SCMP_ACT_NOTIFY, SCMP_SYS(clone));
      add(SCMP_ACT_NOTIFY, SCMP_SYS(execve));
      add(SCMP_ACT_NOTIFY, SCMP_SYS(execveat));
      add(SCMP_ACT_NOTIFY, SCMP_SYS(kill));
      decide_on_signals();
    } else {
      add(SCMP_ACT_ERRNO(EPERM), SCMP_SYS(clone), argument(0, SCMP_CMP_MASKED_EQ, CLONE_THREAD, 0));
      deny(SCMP_SYS(kill));  // abort() sends its signal by tgkill
      if (!kind_.scoped) decide_on_signals();
    }
  }

  void decide_on_file_changes() {
    for (const int call : kFileChanges) add(asked(), call);
  }

  // Without a watcher, abort() ends by its other means, an instruction that there is not.
  void decide_on_signals() {
    for (const int call : kSignals) add(asked(), call);
  }

  void watch() {
    for (const PathCall& call : path_calls()) add(SCMP_ACT_NOTIFY, call.number);
  }

  // What libseccomp cannot say beside its own rules: it knows of calls one by one and no order of
  // them, and has one answer for a call that is put to the watcher.
  static SyscallFilter before_rules() {
    SyscallFilter filter{BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)),
                         BPF_JUMP(BPF_JMP | BPF_JGE | BPF_K, kOtherNumbers, 2, 0),
                         BPF_JUMP(BPF_JMP | BPF_JGT | BPF_K, kNewestCall, 0, 1),
                         BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | ENOSYS)};
    deny_emptying(SCMP_SYS(open), 1, filter);
    deny_emptying(SCMP_SYS(openat), 2, filter);
    return filter;
  }

  // To open a file for reading, and empty it: Landlock's first ABIs take it for reading.
  static void deny_emptying(int call, unsigned flags, SyscallFilter& filter) {
    if (call < 0) return;  // this machine does not have it
    const auto argument =
        static_cast<std::uint32_t>(offsetof(seccomp_data, args) + std::size_t{8} * flags);
    const sock_filter steps[] = {
        BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)),
        BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, static_cast<std::uint32_t>(call), 0, 4),
        BPF_STMT(BPF_LD | BPF_W | BPF_ABS, argument),
        BPF_STMT(BPF_ALU | BPF_AND | BPF_K, O_TRUNC | O_ACCMODE),
        BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, O_TRUNC, 0, 1),
        BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | EPERM)};
    filter.insert(filter.end(), std::begin(steps), std::end(steps));
  }

  SyscallFilter program() const {
    // A pipe takes more than the kernel's longest filter. Not every caller may have a file in
    // memory.
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) throw_errno("pipe");
    const Descriptor from(ends[0]);
    Descriptor to(ends[1]);
    const int failure = seccomp_export_bpf(context_.get(), to.get());
    to.reset();
    SyscallFilter filter = kind_.confine ? before_rules() : SyscallFilter();
    const std::size_t before = filter.size();
    std::array<sock_filter, 64> part;
    for (ssize_t n = 0; (n = read(from.get(), part.data(), sizeof part)) > 0;) {
      filter.insert(filter.end(), part.begin(),
                    part.begin() + n / static_cast<ssize_t>(sizeof(sock_filter)));
    }
    if (failure != 0 || filter.size() == before) {
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
  static std::array<std::optional<SyscallFilter>, 128> made;
  const std::lock_guard lock(mutex);
  auto& filter = made[(kind.confine ? 1u : 0u) + (kind.processes ? 2u : 0u) +
                      (kind.watch ? 4u : 0u) + (kind.asked ? 8u : 0u) + (kind.scoped ? 16u : 0u) +
                      (kind.network ? 32u : 0u) + (kind.narrows ? 64u : 0u)];
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
