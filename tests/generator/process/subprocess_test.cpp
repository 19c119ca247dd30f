#include "process/subprocess.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <stdlib.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <fstream>
#include <functional>
#include <thread>

#include "base/cancellation.h"
#include "base/files.h"
#include "base/stopwatch.h"
#include "base/temporary_folder.h"

namespace mjcourse {
namespace {

using End = Outcome::End;

Command shell(const std::string& script, double seconds = 10) {
  Command command;
  command.arguments = {"sh", "-c", script};
  command.seconds = seconds;
  return command;
}

double seconds_of(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// Whether process `id` ends within a second; a zombie that nobody waited for has ended.
bool ends(int id) {
  for (int i = 0; i < 100; ++i) {
    std::string name, state;
    std::ifstream stat("/proc/" + std::to_string(id) + "/stat");
    if (!(stat >> id >> name >> state) || state == "Z" || state == "X") return true;
    usleep(10000);
  }
  return false;
}

TEST(Subprocess, TellsTheExitCodeAndBothStreams) {
  const Outcome outcome = run(shell("echo good; echo bad >&2; exit 3"));
  EXPECT_EQ(outcome.end, End::exited);
  EXPECT_EQ(outcome.code, 3);
  EXPECT_EQ(outcome.out, "good\n");
  EXPECT_EQ(outcome.err, "bad\n");
}

TEST(Subprocess, TellsTheSignalThatKilled) {
  const Outcome outcome = run(shell("echo last words; kill -SEGV $$"));
  EXPECT_EQ(outcome.end, End::killed_by_signal);
  EXPECT_EQ(outcome.code, SIGSEGV);
  EXPECT_EQ(outcome.out, "last words\n");
}

TEST(Subprocess, GivesAnEmptyStdin) {
  // What this test's own stdin holds must not reach the program.
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  ASSERT_EQ(write(ends[1], "leak\n", 5), 5);
  close(ends[1]);
  const int own = dup(STDIN_FILENO);
  dup2(ends[0], STDIN_FILENO);
  const Outcome outcome = run(shell("cat; echo end"));
  dup2(own, STDIN_FILENO);
  close(own);
  close(ends[0]);
  EXPECT_EQ(outcome.out, "end\n");
}

TEST(Subprocess, RunsInItsFolder) {
  const TemporaryFolder folder;
  Command command = shell("pwd");
  command.folder = folder.path();
  EXPECT_EQ(run(command).out, folder.path().string() + "\n");
}

TEST(Subprocess, DoesNotStartInAFolderThatIsNotThere) {
  Command command = shell("echo started");
  command.folder = "/nowhere";
  const Outcome outcome = run(command);
  EXPECT_EQ(outcome.end, End::not_started);
  EXPECT_EQ(outcome.code, ENOENT);
}

TEST(Subprocess, SaysThatAProgramWasNotFound) {
  Command command;
  command.arguments = {"no-such-program-anywhere"};
  const Outcome outcome = run(command);
  EXPECT_EQ(outcome.end, End::not_started);
  EXPECT_EQ(outcome.code, ENOENT);
}

TEST(Subprocess, AddsToTheEnvironment) {
  Command command = shell("echo $MJCOURSE_TEST_NAME; test -n \"$PATH\"");
  command.environment = {"MJCOURSE_TEST_NAME=a b"};
  const Outcome outcome = run(command);
  EXPECT_EQ(outcome.out, "a b\n");
  EXPECT_EQ(outcome.code, 0);
}

TEST(Subprocess, PrefersItsOwnEnvironmentToTheGenerators) {
  setenv("MJCOURSE_TEST_NAME", "outer", 1);
  for (const char* program : {"sh", "bash"}) {
    Command command = shell("echo $MJCOURSE_TEST_NAME; env | grep -c ^MJCOURSE_TEST_NAME=");
    command.arguments[0] = program;
    command.environment = {"MJCOURSE_TEST_NAME=inner"};
    EXPECT_EQ(run(command).out, "inner\n1\n") << program;
  }
  unsetenv("MJCOURSE_TEST_NAME");
}

TEST(Subprocess, StopsWhatRunsOverItsTime) {
  Outcome outcome;
  const double seconds = seconds_of([&] { outcome = run(shell("echo begun; sleep 60", 0.3)); });
  EXPECT_EQ(outcome.end, End::timed_out);
  EXPECT_EQ(outcome.out, "begun\n");
  EXPECT_LT(seconds, 20);
}

TEST(Subprocess, StopsWhatClosedItsStreamsAndRunsOn) {
  EXPECT_EQ(run(shell("exec >&- 2>&-; sleep 60", 0.3)).end, End::timed_out);
}

TEST(Subprocess, StopsTheGrandchildrenToo) {
  const Outcome outcome = run(shell("sh -c 'sleep 60 & echo $!; wait' & wait", 0.3));
  EXPECT_EQ(outcome.end, End::timed_out);
  EXPECT_TRUE(ends(std::stoi(outcome.out)));
}

TEST(Subprocess, StopsWhatTheProgramLeftBehind) {
  const Outcome outcome = run(shell("sleep 60 >/dev/null 2>&1 & echo $!"));
  EXPECT_EQ(outcome.end, End::exited);
  EXPECT_TRUE(ends(std::stoi(outcome.out)));
}

TEST(Subprocess, CutsAFlood) {
  Command command = shell("yes flood");
  command.output_bytes = 1000;
  const Outcome outcome = run(command);
  EXPECT_EQ(outcome.end, End::flooded);
  EXPECT_EQ(outcome.out.size(), 1000u);
  EXPECT_EQ(outcome.out.substr(0, 12), "flood\nflood\n");
}

TEST(Subprocess, CutsAFloodOfComplaints) {
  Command command = shell("yes flood >&2");
  command.output_bytes = 1000;
  EXPECT_EQ(run(command).end, End::flooded);
}

TEST(Subprocess, TakesAllThatTheLimitAllows) {
  Command command = shell("head -c 100000 /dev/zero");
  command.output_bytes = 100000;
  const Outcome outcome = run(command);
  EXPECT_EQ(outcome.end, End::exited);
  EXPECT_EQ(outcome.out, std::string(100000, '\0'));
}

// The generator ignores or handles signals that a program must meet as the system made them.
TEST(Subprocess, HearsLinesAndAnswersThem) {
  Command command = shell("echo one >&0; read reply; echo $reply; echo two >&0; printf three >&0");
  std::vector<std::string> lines;
  command.hears = [&](std::string_view line) {
    lines.emplace_back(line);
    return std::to_string(line.size()) + "\n";
  };
  const Outcome outcome = run(command);
  EXPECT_EQ(outcome.end, End::exited);
  EXPECT_EQ(outcome.out, "3\n");
  EXPECT_EQ(lines, (std::vector<std::string>{"one", "two"}));  // the third never ended
}

TEST(Subprocess, HearsWhatWasSaidBeforeTheEndThoughNobodyListens) {
  Command command = shell("for i in 1 2 3 4 5; do echo $i >&0; done; exit 4");
  std::string all;
  command.hears = [&](std::string_view line) {
    all += line;
    return std::string("an answer that nobody reads\n");
  };
  const Outcome outcome = run(command);
  EXPECT_EQ(outcome.code, 4);
  EXPECT_EQ(all, "12345");
}

TEST(Subprocess, StopsWhatSaysTooMuch) {
  Command command = shell("yes >&0");
  command.hears = [](std::string_view) { return std::string(); };
  EXPECT_EQ(run(command).end, End::flooded);
}

TEST(Subprocess, StartsWithTheSystemsSignals) {
  const auto before = signal(SIGPIPE, SIG_IGN);
  const Outcome outcome = run(shell("kill -PIPE $$; echo survived"));
  signal(SIGPIPE, before);
  EXPECT_EQ(outcome.end, End::killed_by_signal);
  EXPECT_EQ(outcome.code, SIGPIPE);
}

// If a child inherited the pipe of another, that one's stream would not end with its program.
TEST(Subprocess, RunsManyAtOnceThatShareNoPipe) {
  const Command count_pipes = shell("ls -l /proc/self/fd | grep -c pipe:");
  const std::string alone = run(count_pipes).out;
  std::vector<std::string> others(6);
  {
    std::vector<std::jthread> threads;
    for (std::string& other : others) {
      threads.emplace_back([&] {
        other = alone;
        for (int i = 0; i < 40 && other == alone; ++i) other = run(count_pipes).out;
      });
    }
  }
  for (const std::string& other : others) EXPECT_EQ(other, alone);
}

TEST(Subprocess, IsKilledWhereItIsWaitedForInVain) {
  const std::stop_source stop;
  const Cancellable cancellable(stop.get_token());
  const std::jthread impatient([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    stop.request_stop();
  });
  Command command;
  command.arguments = {"sleep", "60"};
  command.folder = "/";
  command.seconds = 60;
  const Stopwatch stopwatch;
  EXPECT_THROW(run(command), Cancelled);
  EXPECT_LT(stopwatch.seconds(), 30);
}

}  // namespace
}  // namespace mjcourse
