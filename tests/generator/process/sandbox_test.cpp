#include "process/sandbox.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <string>
#include <vector>

#include "base/files.h"
#include "base/temporary_folder.h"
#include "process/subprocess.h"

namespace mjcourse {
namespace {

using End = Outcome::End;
namespace fs = std::filesystem;

// A shell is a program like another, and does these things by itself: it reads by `read x <file`,
// writes by `>file`, and starts a process for whatever is not its own.
class SandboxTest : public testing::Test {
 protected:
  SandboxTest() {
    fs::create_directory(own_);
    fs::create_directory(models_);
    write_file(models_ / "a.xml", "a model\n");
    write_file(folder_.path() / "secret", "a secret\n");
  }

  Command shell(const std::string& script, double seconds = 1) const {
    Command command;
    command.arguments = {"/bin/sh", "-c", script};
    command.folder = own_;
    command.environment = {"MODELS=" + models_.string(), "OUTSIDE=" + folder_.path().string()};
    command.seconds = seconds;
    command.sandbox = Sandbox{{models_}, {own_}};
    return command;
  }
  // The same with somebody to ask.
  Command watched(const std::string& script, double seconds = 1) const {
    Command command = shell(script, seconds);
    command.record_opened = true;
    return command;
  }
  std::vector<std::string> opened_by(const std::string& script) const {
    const Outcome outcome = run(watched(script));
    EXPECT_EQ(outcome.end, End::exited) << outcome.refused;
    return outcome.opened.value_or(std::vector<std::string>{"unknown"});
  }

  const TemporaryFolder folder_;
  const fs::path own_ = folder_.path() / "own", models_ = folder_.path() / "models";
};

TEST_F(SandboxTest, NamesTheLayersThatHold) {
  EXPECT_TRUE(sandbox_level().text().starts_with("rlimits, no_new_privs, seccomp"))
      << sandbox_level().text();
  EXPECT_EQ(sandbox_level().user != SandboxLevel::User::same, geteuid() == 0);
}

TEST_F(SandboxTest, LetsAProgramReadItsModelsAndWriteItsFolder) {
  for (const bool watch : {false, true}) {
    Command command = shell("read x <$MODELS/a.xml; echo $x; echo y >f; read y <f; echo $y $0");
    command.record_opened = watch;
    const Outcome outcome = run(command);
    EXPECT_EQ(outcome.end, End::exited) << outcome.refused << outcome.code;
    EXPECT_EQ(outcome.out, "a model\ny /bin/sh\n") << outcome.err;
  }
}

// The C library asks for this where a thread gives back memory.
TEST_F(SandboxTest, LetsAProgramAskHowMemoryIsGivenOut) {
  const Outcome outcome = run(shell("read x </proc/sys/vm/overcommit_memory; echo ${#x}"));
  EXPECT_EQ(outcome.out, "1\n") << outcome.refused << outcome.err;
}

// A course, or the folder for temporary files, may be closed to everybody but us.
TEST_F(SandboxTest, ReadsAndWritesInAFolderThatIsClosedToOthers) {
  fs::permissions(folder_.path(), fs::perms::owner_all);
  if (geteuid() == 0 && sandbox_level().landlock == 0) GTEST_SKIP() << "not without Landlock";
  Command command = shell("read x <$MODELS/a.xml; echo $x >f; [ -w $PWD/f ] && echo ok");
  command.sandbox->reads_all = true;
  const Outcome outcome = run(command);
  EXPECT_EQ(outcome.out, "ok\n") << outcome.err;
}

TEST_F(SandboxTest, GivesAProgramNoneOfOurEnvironment) {
  setenv("MJCOURSE_TEST_SECRET", "secret", 1);
  const Outcome outcome = run(shell("echo $MJCOURSE_TEST_SECRET $HOME $LC_ALL"));
  unsetenv("MJCOURSE_TEST_SECRET");
  EXPECT_EQ(outcome.out, own_.string() + " C.UTF-8\n");
}

TEST_F(SandboxTest, MakesUsNobodyWhereWeAreRoot) {
  const Outcome outcome = run(shell("while read -r line; do echo $line; done </proc/self/status"));
  EXPECT_EQ(outcome.out.find("Uid: 0 0 0 0"), std::string::npos) << outcome.out;
  EXPECT_EQ(outcome.out.find("Gid: 0 0 0 0"), std::string::npos);
  EXPECT_NE(outcome.out.find("NoNewPrivs: 1"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("Seccomp: 2"), std::string::npos);
  EXPECT_NE(outcome.out.find("CapEff: 0000000000000000"), std::string::npos) << outcome.out;
}

// What is left of root can read, where Landlock lets it, and nothing more.
TEST_F(SandboxTest, KeepsOneCapabilityWhereThatIsSaid) {
  Command command = shell("while read -r line; do echo $line; done </proc/self/status");
  command.sandbox->reads_all = true;
  const std::string kept = sandbox_level().landlock > 0 && geteuid() == 0 ? "4" : "0";
  const Outcome outcome = run(command);
  EXPECT_NE(outcome.out.find("CapEff: 000000000000000" + kept), std::string::npos) << outcome.out;
}

TEST_F(SandboxTest, KeepsFilesOfRootInTheSystemsFolders) {
  if (geteuid() != 0) GTEST_SKIP() << "we are not root";
  std::string folder = "/usr/local/mjcourse-test-XXXXXX";
  if (mkdtemp(folder.data()) == nullptr) GTEST_SKIP() << "/usr/local is not ours to write";
  fs::permissions(folder, fs::perms(0755));
  write_file(fs::path(folder) / "secret", "a secret\n");
  fs::permissions(fs::path(folder) / "secret", fs::perms(0600));
  for (const bool processes : {false, true}) {
    Command command = shell("read x <" + folder + "/secret && echo \"$x\"");
    command.sandbox->processes = processes;
    EXPECT_EQ(run(command).out, "") << processes;
  }
  fs::remove_all(folder);
}

TEST_F(SandboxTest, StopsWhoReadsOutsideAndTellsWhat) {
  for (const std::string path :
       {"/etc/passwd", "$OUTSIDE/secret", "../secret", "/proc/1/environ"}) {
    const Outcome outcome = run(watched("read x <" + path + "; echo $x"));
    EXPECT_EQ(outcome.end, End::refused) << path << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_TRUE(outcome.refused.starts_with("read ")) << outcome.refused;
  }
  EXPECT_EQ(run(watched("read x </etc/passwd")).refused, "read /etc/passwd");
  EXPECT_EQ(run(watched("read x <../secret")).refused, "read ../secret");
}

TEST_F(SandboxTest, StopsALinkThatLeadsOutside) {
  fs::create_symlink("/etc/passwd", own_ / "link");
  EXPECT_EQ(run(watched("read x <link")).refused, "read link");
  if (sandbox_level().landlock > 0) {
    EXPECT_EQ(run(shell("read x <link && echo $x")).out, "");
  }
}

// Mesa tries this by itself where it draws.
TEST_F(SandboxTest, DeniesADeviceThatAProgramCanDoWithout) {
  const Outcome outcome = run(watched("echo x >/dev/udmabuf || echo denied"));
  EXPECT_EQ(outcome.out, "denied\n") << outcome.refused;
}

TEST_F(SandboxTest, StopsWhoWritesOutside) {
  const std::string shared = "/dev/shm/" + folder_.path().filename().string();
  for (const std::string& path :
       std::vector<std::string>{"$OUTSIDE/new", "$MODELS/a.xml", "$MODELS/new", shared}) {
    EXPECT_TRUE(run(watched("echo x >" + path)).refused.starts_with("write ")) << path;
    const bool held = sandbox_level().landlock > 0;
    EXPECT_TRUE(!held || run(shell("echo x >" + path)).code != 0) << path;
  }
  EXPECT_FALSE(fs::exists(folder_.path() / "new"));
  EXPECT_FALSE(fs::exists(shared));
  EXPECT_EQ(DiskFiles(models_).read("a.xml").value(), "a model\n");
}

TEST_F(SandboxTest, StopsWhoStartsAnotherProcess) {
  EXPECT_EQ(run(watched("sleep 60 &")).refused, "start another process");
  EXPECT_NE(run(shell("sleep 60 & echo $!")).code, 0);
  EXPECT_EQ(run(watched("exec cat $MODELS/a.xml")).refused, "start another program");
}

TEST_F(SandboxTest, StopsWhoSignalsOthers) {
  EXPECT_EQ(run(watched("kill -9 $PPID")).refused, "send a signal to another process");
  EXPECT_EQ(run(watched("kill -9 -1")).refused, "send a signal to another process");
  EXPECT_NE(run(shell("kill -9 $PPID")).code, 0);
}

TEST_F(SandboxTest, LetsAProgramSignalItself) {
  const Outcome outcome = run(watched("kill -TERM $$; echo survived"));
  EXPECT_EQ(outcome.end, End::killed_by_signal) << outcome.refused;
  EXPECT_EQ(outcome.code, SIGTERM);
}

// A compiler's driver starts other programs; they cannot leave its group, and end with it.
TEST_F(SandboxTest, LetsProcessesBeStartedWhereItSaysSo) {
  Command command = shell("cat $MODELS/a.xml; setsid sleep 60; echo $?");
  command.sandbox->processes = true;
  EXPECT_EQ(run(command).out, "a model\n1\n");
}

TEST_F(SandboxTest, BoundsAFile) {
  Command command = shell("while :; do echo 0123456789012345678901234567890123456789; done >f");
  command.sandbox->file_bytes = 100'000;
  const Outcome outcome = run(command);
  EXPECT_EQ(outcome.end, End::killed_by_signal);
  EXPECT_EQ(outcome.code, SIGXFSZ);
  EXPECT_EQ(fs::file_size(own_ / "f"), 100'000u);
}

TEST_F(SandboxTest, BoundsAllFilesTogether) {
  const std::string many = "i=0; while :; do i=$((i+1)); echo x >f$i; done";
  Command command = shell(many, 60);
  command.sandbox->folder_entries = 100;
  EXPECT_EQ(run(command).end, End::overfilled);
  command = shell("mkdir d || exit; " + many, 60);
  command.sandbox->processes = true;
  command.sandbox->folder_bytes = 1 << 20;
  EXPECT_EQ(run(command).end, End::overfilled);
}

// What lies so deep, or under so long a name, that counting it takes longer than filling it.
TEST_F(SandboxTest, BoundsTheDepthOfFolders) {
  Command command =
      shell("i=0; while [ $i -lt 200 ]; do mkdir d; cd d; i=$((i+1)); done; sleep 60", 60);
  command.sandbox->processes = true;
  EXPECT_EQ(run(command).end, End::overfilled);
  const std::string name(250, 'n');
  command = shell("i=0; while [ $i -lt 20 ]; do mkdir " + name + "; cd " + name +
                      "; i=$((i+1)); done; sleep 60",
                  60);
  command.sandbox->processes = true;
  EXPECT_EQ(run(command).end, End::overfilled);
}

// Files on their way in a socket are held by it, and counted by nobody.
TEST_F(SandboxTest, GivesAProgramNoSockets) {
  EXPECT_EQ(
      run(shell("exec perl -MSocket -e 'print socketpair(A, B, AF_UNIX, SOCK_STREAM, 0) ? 1 : 0'"))
          .out,
      "0");
}

// Each by itself is within the limit.
TEST_F(SandboxTest, BoundsTheMemoryOfAllProcessesTogether) {
  const std::string one = "perl -e '$x = \"x\" x (60 << 20); print 1; sleep 60' & ";
  Command command = shell(one + one + one + "wait", 60);
  command.sandbox->processes = true;
  command.sandbox->memory_bytes = 150 << 20;
  EXPECT_EQ(run(command).end, End::exhausted);
  command = shell("perl -e '$x = \"x\" x (60 << 20); select(undef, undef, undef, 0.3)'", 60);
  command.sandbox->processes = true;
  command.sandbox->memory_bytes = 150 << 20;
  EXPECT_EQ(run(command).end, End::exited);
}

TEST_F(SandboxTest, BoundsFilesThatWereRemovedAndAreOpen) {
  const std::string fill =
      "for my $i (1 .. 9) { open($f[$i], q(>), q(f)); unlink(q(f)); print {$f[$i]} q(x) x (1 << "
      "20);"
      "$f[$i]->flush() } sleep 60";
  for (const bool processes : {false, true}) {
    Command command = shell("exec perl -MIO::Handle -e '" + fill + "'", 60);
    command.sandbox->processes = processes;
    command.sandbox->folder_bytes = 4 << 20;
    EXPECT_EQ(run(command).end, End::overfilled);
  }
}

TEST_F(SandboxTest, BoundsFilesThatWereRemovedAndAreMapped) {
  const std::string fill =
      "for (1 .. 9) { open($f, q(+>), q(f)); unlink(q(f)); print {$f} q(x) x (1 << 20); "
      "$f->flush(); syscall(" +
      std::to_string(SYS_mmap) + ", 0, 4096, 1, 1, fileno($f), 0) > 0 or die; close($f) } sleep 60";
  for (const bool processes : {false, true}) {
    Command command = shell("exec perl -MIO::Handle -e '" + fill + "'", 60);
    command.sandbox->processes = processes;
    command.sandbox->file_bytes = 2 << 20;
    command.sandbox->folder_bytes = 4 << 20;
    const Outcome outcome = run(command);
    EXPECT_EQ(outcome.end, End::overfilled) << outcome.err << outcome.refused;
  }
}

// Root sees into every folder.
TEST_F(SandboxTest, TakesAFolderThatNobodySeesIntoForAFullOne) {
  Command command = shell("umask 0777; mkdir d && sleep 60", 60);
  command.sandbox->processes = true;
  command.seconds = geteuid() == 0 ? 0.3 : 60;
  EXPECT_EQ(run(command).end, geteuid() == 0 ? End::timed_out : End::overfilled);
}

TEST_F(SandboxTest, BoundsMemory) {
  Command command = shell("x=0123456789; while :; do x=$x$x; done", 60);
  command.sandbox->memory_bytes = 100 << 20;
  const Outcome outcome = run(command);
  EXPECT_NE(outcome.end, End::timed_out);
  EXPECT_NE(outcome.code, 0);
}

TEST_F(SandboxTest, RecordsWhatWasOpenedAndLookedFor) {
  if (!sandbox_level().watch) GTEST_SKIP() << "this kernel cannot ask about files";
  const std::string a = models_ / "a.xml", gone = models_ / "gone.xml";
  EXPECT_EQ(opened_by("echo x >own-file"), std::vector<std::string>{});
  // As realpath does of the program itself, which Mesa wants to know.
  EXPECT_EQ(opened_by("[ -e .. ]; [ -e ../.. ]; [ -e / ]"), std::vector<std::string>{});
  EXPECT_EQ(opened_by("read x <$MODELS/a.xml; [ -f $MODELS/gone.xml ]; :"),
            (std::vector<std::string>{a, gone}));
  // However the name is made.
  EXPECT_EQ(opened_by("cd $MODELS; read x <./../models//a.xml; n=gone; [ -e $n.xml ] || :"),
            (std::vector<std::string>{models_, a, gone}));
}

TEST_F(SandboxTest, RecordsTheFilesOfOtherProcessesToo) {
  if (!sandbox_level().watch) GTEST_SKIP() << "this kernel cannot ask about files";
  Command command = watched("(cat $MODELS/a.xml); ls $MODELS");
  command.sandbox->processes = true;
  const Outcome outcome = run(command);
  EXPECT_EQ(outcome.out, "a model\na.xml\n") << outcome.err << outcome.refused;
  EXPECT_EQ(outcome.opened.value(),
            (std::vector<std::string>{models_.string(), models_ / "a.xml"}));
}

TEST_F(SandboxTest, RecordsNothingThatWasNotAskedFor) {
  EXPECT_FALSE(run(shell(":")).opened);
}

}  // namespace
}  // namespace mjcourse
