#include <fcntl.h>
#include <gtest/gtest.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <vector>

#include "base/files.h"
#include "base/temporary_folder.h"
#include "process/sandbox.h"
#include "process/subprocess.h"

namespace mjcourse {
namespace {

using End = Outcome::End;
namespace fs = std::filesystem;

// Who makes system calls: a program of a lesson's, one that nobody watches, and a lesson's
// commands.
enum class Who { program, tool, commands };
// Perl's name of it reads as something else before a comma.
const std::string kOwnId = "syscall(" + std::to_string(SYS_getpid) + ")";
constexpr Who kAll[] = {Who::program, Who::tool, Who::commands};

// Perl makes any system call by its number, and says in `$!` what came of it.
class ConfinedCallsTest : public testing::Test {
 protected:
  ConfinedCallsTest() {
    fs::create_directory(own_);
    fs::permissions(own_, fs::perms::all);
    write_file(foreign_, "a file of somebody else's\n");
  }

  Outcome perl(const std::string& script, Who who) const {
    Command command;
    command.arguments = {"/usr/bin/perl", "-e", script};
    command.folder = own_;
    command.environment = {"FOREIGN=" + foreign_.string()};
    command.sandbox = Sandbox{{foreign_}, {own_}};
    command.sandbox->processes = who == Who::commands;
    command.record_opened = who == Who::program;
    return run(command);
  }
  // The errno of a system call; 0 where it is done.
  int error_of(long number, const std::string& arguments, Who who) const {
    const Outcome outcome =
        perl("print syscall(" + std::to_string(number) + (arguments.empty() ? "" : ", ") +
                 arguments + ") < 0 ? $! + 0 : 0",
             who);
    EXPECT_EQ(outcome.end, End::exited) << outcome.refused << outcome.code << outcome.err;
    return outcome.out.empty() ? -1 : std::stoi(outcome.out);
  }

  const TemporaryFolder folder_;
  const fs::path own_ = folder_.path() / "own", foreign_ = folder_.path() / "foreign";
};

// Of the kernel's behaviour that nobody knew when the lists were written, a program gets none.
TEST_F(ConfinedCallsTest, KnowsNoCallsThatAreNewerThanTheLists) {
  constexpr int fchmodat2 = 452, setxattrat = 463, removexattrat = 466, open_tree_attr = 467;
  constexpr int file_setattr = 469, first = 451, not_yet = 600;
  for (const Who who : kAll) {
    for (const int call :
         {first, fchmodat2, setxattrat, removexattrat, open_tree_attr, file_setattr, not_yet}) {
      EXPECT_EQ(error_of(call, "-100, $ENV{FOREIGN}, 0777, 0, 0", who), ENOSYS) << call;
    }
  }
}

#ifdef __x86_64__
TEST_F(ConfinedCallsTest, EndsWhoTakesTheNumbersForOtherAddresses) {
  const Outcome outcome = perl("syscall(0x40000000 | 39); print 1", Who::tool);
  EXPECT_EQ(outcome.end, End::killed_by_signal);
  EXPECT_EQ(outcome.code, SIGSYS);
}
#endif

TEST_F(ConfinedCallsTest, LetsNobodyScheduleOthers) {
  for (const Who who : kAll) {
    const std::string mask = "getppid(), 8, my $mask = pack('Q', 1)",
                      rule = "my $rule = pack('L12', 48)";
    EXPECT_EQ(error_of(SYS_sched_setaffinity, mask, who), EPERM);
    EXPECT_EQ(error_of(SYS_sched_setscheduler, "getppid(), 0, my $p = pack('L', 0)", who), EPERM);
    EXPECT_EQ(error_of(SYS_sched_setparam, "getppid(), my $p = pack('L', 0)", who), EPERM);
    EXPECT_EQ(error_of(SYS_sched_setattr, "getppid(), " + rule + ", 0", who), EPERM);
    EXPECT_EQ(error_of(SYS_sched_setaffinity, "0, 8, my $mask = pack('Q', 1)", who), 0);
  }
}

// As a library does for each of its threads.
TEST_F(ConfinedCallsTest, LetsAProgramScheduleItsThreads) {
  if (!sandbox_level().watch) GTEST_SKIP() << "nobody can be asked whose thread it is";
  EXPECT_EQ(error_of(SYS_sched_setaffinity, kOwnId + ", 8, my $mask = pack('Q', 1)", Who::program),
            0);
}

// The process that has a descriptor says to which process the kernel sends a signal of it, and
// which. Of the number of such a request, it takes half of what is given.
TEST_F(ConfinedCallsTest, LetsNobodyGiveDescriptorsToOthers) {
  for (const Who who : kAll) {
    for (const int request : {F_SETOWN, F_SETSIG, F_SETOWN_EX}) {
      const std::string number = std::to_string(request);
      EXPECT_EQ(error_of(SYS_fcntl, "1, " + number + ", getppid()", who), EPERM);
      EXPECT_EQ(error_of(SYS_fcntl, "1, (1 << 32) | " + number + ", getppid()", who), EPERM);
    }
    for (const std::string request : {"0x8901", "0x8902", "0x5412"}) {
      EXPECT_EQ(error_of(SYS_ioctl, "1, " + request + ", my $id = pack('L', 1)", who), EPERM);
      EXPECT_EQ(error_of(SYS_ioctl, "1, (1 << 32) | " + request + ", my $id = pack('L', 1)", who),
                EPERM);
    }
    EXPECT_EQ(error_of(SYS_prctl, std::to_string(PR_SET_PDEATHSIG) + ", 0, 0, 0, 0", who), EPERM);
    EXPECT_EQ(error_of(SYS_prctl,
                       "(1 << 32) | " + std::to_string(PR_SET_PDEATHSIG) + ", 0, 0, 0, 0", who),
              EPERM);
  }
}

TEST_F(ConfinedCallsTest, LetsNobodySeeWhatOthersDoWithFiles) {
  for (const Who who : kAll) {
    EXPECT_EQ(error_of(SYS_inotify_init1, "0", who), EPERM);
    EXPECT_EQ(error_of(SYS_fanotify_init, "0, 0", who), EPERM);
    EXPECT_EQ(error_of(SYS_fanotify_mark, "0, 0, 0, 0, 0", who), EPERM);
    EXPECT_EQ(error_of(SYS_fcntl, "0, " + std::to_string(F_NOTIFY) + ", 1", who), EPERM);
  }
}

// The next process that opens such a file waits for the program to end.
TEST_F(ConfinedCallsTest, LetsNobodyLeaseFiles) {
  const std::string open = "open($f, '<', $ENV{FOREIGN}) ? fileno($f) : -1, ";
  const std::string request = std::to_string(F_SETLEASE);
  for (const Who who : kAll) {
    for (const int lease : {F_RDLCK, F_WRLCK}) {
      EXPECT_EQ(error_of(SYS_fcntl, open + request + ", " + std::to_string(lease), who), EPERM);
    }
    EXPECT_EQ(error_of(SYS_fcntl, open + "(1 << 32) | " + request + ", 0", who), EPERM);
  }
}

// Whatever is kept there, and whether there is such a file.
TEST_F(ConfinedCallsTest, TellsNoAttributesOfFiles) {
  for (const Who who : kAll) {
    for (const long call : {SYS_getxattr, SYS_lgetxattr}) {
      EXPECT_EQ(error_of(call, "$ENV{FOREIGN}, my $n = 'user.note', $b = 'x' x 99, 99", who),
                EOPNOTSUPP);
      EXPECT_EQ(
          error_of(call, "my $p = '/etc/shadow', my $n = 'user.note', $b = 'x' x 99, 99", who),
          EOPNOTSUPP);
    }
    for (const long call : {SYS_listxattr, SYS_llistxattr}) {
      EXPECT_EQ(error_of(call, "$ENV{FOREIGN}, $b = 'x' x 99, 99", who), EOPNOTSUPP);
    }
    EXPECT_EQ(error_of(SYS_fgetxattr, "0, my $n = 'user.note', $b = 'x' x 99, 99", who),
              EOPNOTSUPP);
    EXPECT_EQ(error_of(SYS_flistxattr, "0, $b = 'x' x 99, 99", who), EOPNOTSUPP);
  }
}

// A file's room costs as long as its bytes take, so that somebody looks meanwhile.
TEST_F(ConfinedCallsTest, GivesNoRoomOnTheDiskForNothing) {
  const std::string open = "(open($f, '>', \"file$$\") ? fileno($f) : -1), 0, 0, 1 << 20";
  for (const Who who : kAll) EXPECT_EQ(error_of(SYS_fallocate, open, who), EOPNOTSUPP);
  for (const Who who : kAll) {
    const Outcome outcome = perl(
        "open($f, '>', \"file$$\"); syswrite($f, 'x' x (1 << 20)); print +(stat(\"file$$\"))[12] * "
        "512",
        who);
    EXPECT_EQ(outcome.out, std::to_string(1 << 20)) << outcome.err;
  }
}

// Signal 0 asks whether another would arrive.
TEST_F(ConfinedCallsTest, LetsNoCommandSignalOthers) {
  for (const Who who : {Who::tool, Who::commands}) {
    EXPECT_EQ(error_of(SYS_kill, "getppid(), 0", who), EPERM);
    EXPECT_EQ(error_of(SYS_tkill, "getppid(), 0", who), EPERM);
    EXPECT_EQ(error_of(SYS_tgkill, "getppid(), getppid(), 0", who), EPERM);
    const std::string info = "my $info = pack('L32', 0, 0, 0xFFFFFFFF)";
    EXPECT_EQ(error_of(SYS_rt_sigqueueinfo, "getppid(), 0, " + info, who), EPERM);
    EXPECT_EQ(error_of(SYS_rt_tgsigqueueinfo, "getppid(), getppid(), 0, " + info, who), EPERM);
  }
}

TEST_F(ConfinedCallsTest, LetsCommandsAbort) {
  const Outcome outcome = perl(
      "syscall(" + std::to_string(SYS_tgkill) + ", " + kOwnId + ", " + kOwnId + ", 6); print 1",
      Who::commands);
  EXPECT_EQ(outcome.end, End::killed_by_signal);
  EXPECT_EQ(outcome.code, SIGABRT);
}

TEST_F(ConfinedCallsTest, KeepsModesAndTimesOfForeignFiles) {
  if (!sandbox_level().watch) GTEST_SKIP() << "nobody can be asked whose file it is";
  fs::permissions(foreign_, fs::perms(0666));
  fs::create_symlink(foreign_, own_ / "link");
  const auto before = fs::last_write_time(foreign_);
  const std::string opened = "open(my $f, '<', $ENV{FOREIGN}) or die; ";
  for (const Who who : kAll) {
    for (const std::string attempt :
         {"chmod(0600, $ENV{FOREIGN})", "chmod(0600, 'link')", "chmod(0600, '../foreign')",
          "chmod(0600, $f)", "chmod(0600, '/proc/self/fd/' . fileno($f))",
          "utime(5, 5, $ENV{FOREIGN})", "utime(5, 5, 'link')", "utime(5, 5, $f)",
          "utime(undef, undef, $f)", "chown($<, -1, $ENV{FOREIGN})", "chown($<, -1, $f)"}) {
      const Outcome outcome = perl(opened + "print " + attempt + ", ' ', $! + 0", who);
      EXPECT_EQ(outcome.out, "0 " + std::to_string(EPERM)) << attempt << outcome.err;
    }
  }
  EXPECT_EQ(fs::status(foreign_).permissions(), fs::perms(0666));
  EXPECT_EQ(fs::last_write_time(foreign_), before);
}

// As a linker does, `touch`, and a program that unpacks an archive.
TEST_F(ConfinedCallsTest, LetsProgramsChangeModesAndTimesOfTheirOwnFiles) {
  if (!sandbox_level().watch) GTEST_SKIP() << "nobody can be asked whose file it is";
  for (const Who who : {Who::program, Who::commands}) {
    const Outcome outcome = perl(
        "sub show { my @s = stat('f'); printf('%o %d,', $s[2] & 07777, $s[9]) }"
        "open(my $f, '>', 'f') or die; chmod(0600, 'f') or die; utime(5, 5, 'f') or die; show();"
        "chmod(04755, $f) or die; utime(6, 6, $f) or die; show();"
        "symlink('f', 'l'); chmod(0640, 'l') or die; chmod(0444, '/proc/self/fd/' . fileno($f));"
        "show(); chmod(0644, 'no such file') and die; print $! + 0; unlink('l')",
        who);
    EXPECT_EQ(outcome.out, "600 5,755 6,444 6," + std::to_string(ENOENT))
        << outcome.err << outcome.refused;
    fs::remove(own_ / "f");
  }
}

// Landlock's first ABIs do not look at it, and a program that is watched is stopped.
TEST_F(ConfinedCallsTest, KeepsForeignFilesFromBeingEmptied) {
  fs::permissions(foreign_, fs::perms(0666));
  const auto size = fs::file_size(foreign_);
  const std::string path = "my $path = $ENV{FOREIGN}, ", number = std::to_string(O_TRUNC);
  for (const Who who : {Who::tool, Who::commands}) {
    EXPECT_EQ(error_of(SYS_truncate, path + "0", who), EPERM);
    EXPECT_EQ(error_of(SYS_openat, "-100, " + path + number + ", 0", who), EPERM);
    EXPECT_EQ(
        error_of(SYS_openat2, "-100, " + path + "my $how = pack('Q3', " + number + "), 24", who),
        ENOSYS);
#ifdef SYS_open
    EXPECT_EQ(error_of(SYS_open, path + number + ", 0", who), EPERM);
#endif
  }
  EXPECT_EQ(fs::file_size(foreign_), size);
  const std::string write = "syscall(" + std::to_string(SYS_truncate) + ", " + path + "0)";
  EXPECT_EQ(perl(write, Who::program).refused, "write " + foreign_.string());
}

TEST_F(ConfinedCallsTest, LetsProgramsCutTheirOwnFiles) {
  if (!sandbox_level().watch) GTEST_SKIP() << "nobody can be asked whose file it is";
  for (const Who who : {Who::program, Who::commands}) {
    const Outcome outcome = perl(
        "open(my $f, '>', 'f') or die; truncate('f', 7) or die; print -s 'f', ' ';"
        "truncate('f', 1 << 40) and die; print $! + 0; unlink('f')",
        who);
    EXPECT_EQ(outcome.out, "7 " + std::to_string(EFBIG)) << outcome.err << outcome.refused;
  }
}

TEST_F(ConfinedCallsTest, ChangesALinkOfItsOwnAndNotWhatItLeadsTo) {
  if (!sandbox_level().watch) GTEST_SKIP() << "nobody can be asked whose file it is";
  const auto before = fs::last_write_time(foreign_);
  const Outcome outcome = perl(
      "symlink($ENV{FOREIGN}, 'l'); print system('touch', '-h', '-d', '@5', 'l'), ' ', "
      "(lstat('l'))[9]",
      Who::commands);
  EXPECT_EQ(outcome.out, "0 5") << outcome.err;
  EXPECT_EQ(fs::last_write_time(foreign_), before);
}

}  // namespace
}  // namespace mjcourse
