#include "course/last_changed.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>

#include "base/files.h"
#include "base/stopwatch.h"
#include "base/temporary_folder.h"
#include "process/subprocess.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

// A repository whose course lies in a folder of it.
class LastChanged : public testing::Test {
 protected:
  LastChanged() { git({"init", "--quiet", "."}); }

  void git(std::vector<std::string> arguments, const std::string& when = "") const {
    Command command;
    command.arguments = {"git", "-c", "user.name=A", "-c", "user.email=a@example.org"};
    command.arguments.insert(command.arguments.end(), arguments.begin(), arguments.end());
    command.folder = folder_.path().string();
    command.environment = {"GIT_COMMITTER_DATE=" + when, "GIT_AUTHOR_DATE=" + when};
    const Outcome outcome = run(command);
    ASSERT_EQ(outcome.code, 0) << outcome.err;
  }
  void write(const std::string& path, const std::string& text) const {
    write_file(folder_.path() / path, text);
  }
  void commit(const std::string& when) const {
    git({"add", "--all"});
    git({"commit", "--quiet", "--message=m"}, when);
  }
  History history(const std::string& course = "course") const {
    return last_changed(folder_.path() / course, "content");
  }
  LastChanges changes(const std::string& course = "course") const {
    const History found = history(course);
    EXPECT_EQ(found.unknown, "");
    return found.changes;
  }

  TemporaryFolder folder_;
};

TEST_F(LastChanged, IsTheNewestCommitOfAFile) {
  write("course/content/1/a.md", "a");
  write("course/content/1/\xC3\xBC.md", "b");
  write("course/other.md", "c");
  commit("2026-03-03T23:30:00-0500");
  write("course/content/1/a.md", "A");
  commit("2026-04-05T01:00:00+0900");
  const LastChanges found = changes();
  ASSERT_EQ(found.size(), 2U);
  // The day of its author, and the moment for all.
  EXPECT_EQ(found.at("content/1/a.md").day, "2026-04-05");
  EXPECT_EQ(found.at("content/1/a.md").time, "2026-04-04T16:00:00Z");
  EXPECT_EQ(found.at("content/1/\xC3\xBC.md").day, "2026-03-03");
  EXPECT_EQ(found.at("content/1/\xC3\xBC.md").time, "2026-03-04T04:30:00Z");
}

TEST_F(LastChanged, IsTheSameInEveryTimeZone) {
  write("course/content/1/a.md", "a");
  commit("2026-03-03T23:30:00-0500");
  setenv("TZ", "Asia/Kathmandu", 1);
  const LastChanges found = changes();
  unsetenv("TZ");
  EXPECT_EQ(found.at("content/1/a.md").day, "2026-03-03");
  EXPECT_EQ(found.at("content/1/a.md").time, "2026-03-04T04:30:00Z");
}

TEST_F(LastChanged, IsNotKnownOfWhatIsInNoCommit) {
  for (const char* name : {"edited", "staged", "same"}) {
    write("course/content/1/" + std::string(name) + ".md", "a");
  }
  commit("2026-03-03T12:00:00Z");
  write("course/content/1/staged.md", "b");
  git({"add", "--all"});
  write("course/content/1/edited.md", "b");
  write("course/content/1/new.md", "b");
  write("course/content/1/same.md", "a");  // as it was, at another time
  const LastChanges found = changes();
  EXPECT_FALSE(found.at("content/1/edited.md").committed());
  EXPECT_FALSE(found.at("content/1/staged.md").committed());
  EXPECT_FALSE(found.at("content/1/new.md").committed());
  EXPECT_EQ(found.at("content/1/same.md").day, "2026-03-03");
}

TEST_F(LastChanged, IsNotKnownOfADayThatIsNone) {
  write("course/content/1/a.md", "a");
  commit("@100000000000000 +0000");
  EXPECT_FALSE(changes().at("content/1/a.md").committed());
}

TEST_F(LastChanged, IsNotGuessedFromAShallowClone) {
  write("course/content/1/a.md", "a");
  commit("2026-03-03T12:00:00Z");
  write("course/content/1/b.md", "b");
  commit("2026-03-04T12:00:00Z");
  git({"clone", "--quiet", "--depth=1", "file://" + folder_.path().string(), "shallow"});
  const History cut = history("shallow/course");
  EXPECT_TRUE(cut.changes.empty());
  EXPECT_EQ(cut.unknown,
            "this is a shallow clone, in which git knows no dates; `git fetch --unshallow` brings "
            "the rest, and so does `fetch-depth: 0` of actions/checkout");
  git({"clone", "--quiet", "file://" + folder_.path().string(), "whole"});
  EXPECT_EQ(changes("whole/course").at("content/1/a.md").day, "2026-03-03");
}

TEST(LastChangedWithoutGit, IsUnknown) {
  const TemporaryFolder folder;
  write_file(folder.path() / "content/a.md", "a");
  const History none = last_changed(folder.path(), "content");
  EXPECT_TRUE(none.changes.empty());
  EXPECT_EQ(none.unknown, "");
}

// As a container finds it.
TEST_F(LastChanged, IsKnownInARepositoryOfAnotherOwner) {
  if (geteuid() != 0) GTEST_SKIP() << "only root can give files away";
  write("course/content/1/a.md", "a");
  commit("2026-03-03T12:00:00Z");
  for (const auto& entry : fs::recursive_directory_iterator(folder_.path())) {
    ASSERT_EQ(lchown(entry.path().c_str(), 65534, 65534), 0);
  }
  ASSERT_EQ(chown(folder_.path().c_str(), 65534, 65534), 0);
  EXPECT_EQ(changes().at("content/1/a.md").day, "2026-03-03");
}

TEST_F(LastChanged, IsUnknownBeforeTheFirstCommit) {
  write("course/content/1/a.md", "a");
  EXPECT_TRUE(changes().empty());
}

TEST_F(LastChanged, SaysWhyItIsUnknown) {
  write("course/content/1/a.md", "a");
  commit("2026-03-03T12:00:00Z");
  write(".git/HEAD", "nonsense\n");
  const History broken = history();
  EXPECT_TRUE(broken.changes.empty());
  EXPECT_EQ(broken.unknown,
            "fatal: not a git repository: '" + (folder_.path() / ".git").string() + "'");
}

// Where an archive, or the repository's maker, put something else.
TEST_F(LastChanged, IsNotWaitedFor) {
  write("course/content/1/a.md", "a");
  commit("2026-03-03T12:00:00Z");
  const fs::path own = folder_.path() / ".git";
  for (const char* name : {"HEAD", "index", "config", "packed-refs", "refs/heads/a/b"}) {
    const fs::path place = own / name;
    const fs::path kept = folder_.path() / "kept";
    const bool was_there = fs::exists(place);
    if (was_there) fs::rename(place, kept);
    fs::create_directories(place.parent_path());
    ASSERT_EQ(mkfifo(place.c_str(), 0666), 0);
    EXPECT_EQ(history().unknown,
              place.string() + " is a pipe or a device, where git has a file; remove it");
    fs::remove(place);
    fs::create_symlink("/dev/zero", place);
    EXPECT_EQ(history().unknown,
              place.string() + " is a pipe or a device, where git has a file; remove it");
    fs::remove(place);
    if (was_there) fs::rename(kept, place);
  }
  EXPECT_EQ(changes().at("content/1/a.md").day, "2026-03-03");
}

// What is not looked for beforehand, as git's objects, costs its time limit.
TEST_F(LastChanged, HasALimitOfTime) {
  write("course/content/1/a.md", "a");
  commit("2026-03-03T12:00:00Z");
  for (const auto& object : fs::recursive_directory_iterator(folder_.path() / ".git/objects")) {
    if (!object.is_regular_file()) continue;
    fs::remove(object.path());
    ASSERT_EQ(mkfifo(object.path().c_str(), 0666), 0);
  }
  const Stopwatch stopwatch;
  EXPECT_EQ(history().unknown, "git does not answer within 10 s");
  EXPECT_LT(stopwatch.seconds(), 20);
}

TEST_F(LastChanged, IsUnknownWhereAFileIsAFolderOrTooLarge) {
  write("course/content/1/a.md", "a");
  commit("2026-03-03T12:00:00Z");
  const fs::path own = folder_.path() / ".git";
  for (const char* name : {"HEAD", "index", "config"}) {
    fs::rename(own / name, own / "kept");
    fs::create_directory(own / name);
    const Stopwatch stopwatch;
    EXPECT_NE(history().unknown, "") << name;
    fs::remove(own / name);
    write(std::string(".git/") + name, "");
    fs::resize_file(own / name, std::uintmax_t{1} << 40);
    EXPECT_NE(history().unknown, "") << name;
    EXPECT_LT(stopwatch.seconds(), 30);
    fs::remove(own / name);
    fs::rename(own / "kept", own / name);
  }
  // One that says where the repository lies.
  fs::rename(own, folder_.path() / "repository");
  write(".git", "gitdir: repository\n");
  fs::resize_file(own, std::uintmax_t{1} << 40);
  EXPECT_EQ(changes().at("content/1/a.md").day, "2026-03-03");
}

// Whatever a repository says that git starts, it starts nothing.
TEST_F(LastChanged, IsNotLookedForInARepositoryOfTooManyFiles) {
  write("course/content/1/a.md", "a");
  commit("2026-03-03T12:00:00Z");
  const fs::path heads = folder_.path() / ".git/refs/heads";
  const std::string why = (folder_.path() / ".git").string() +
                          " has too many files besides its objects, or too deep ones";
  fs::path deep = heads;
  for (int i = 0; i < 150; ++i) deep /= "d";
  fs::create_directories(deep);
  EXPECT_EQ(history().unknown, why);
  fs::remove_all(heads / "d");
  EXPECT_EQ(history().unknown, "");
  fs::create_directory(heads / "many");
  for (int i = 0; i < 10'000; ++i) {
    std::ofstream(heads / "many" / std::to_string(i));
  }
  EXPECT_EQ(history().unknown, why);
}

class HostileRepository : public LastChanged {
 protected:
  HostileRepository() {
    const fs::path script = folder_.path() / "script";
    write("script", "#!/bin/sh\ntouch '" + mark_.string() + "'\ncat\n");
    fs::permissions(script, fs::perms(0755));
    settings_ =
        "[core]\n\trepositoryformatversion = 0\n\tfsmonitor = " + script.string() +
        "\n\tsshCommand = " + script.string() + "\n\tpager = " + script.string() +
        "\n\thooksPath = " + folder_.path().string() + "\n[diff]\n\texternal = " + script.string() +
        "\n[diff \"x\"]\n\ttextconv = " + script.string() + "\n\tcommand = " + script.string() +
        "\n[filter \"x\"]\n\tclean = " + script.string() + "\n[alias]\n\tlog = !" +
        script.string() + "\n\tls-files = !" + script.string() + "\n";
    write("course/content/1/a.md", "a");
    write("course/content/1/b.md", "b");
  }
  bool started() const { return fs::exists(mark_); }

  // Beside what would be seen as a file of the course.
  TemporaryFolder elsewhere_;
  const fs::path mark_ = elsewhere_.path() / "started";
  std::string settings_;
};

TEST_F(HostileRepository, StartsNothing) {
  commit("2026-03-03T12:00:00Z");
  fs::permissions(elsewhere_.path(), fs::perms::all);
  write(".git/config", settings_);
  write(".git/info/attributes", "*.md filter=x diff=x\n");
  write("course/content/1/b.md", "c");  // as long as before
  const LastChanges found = changes();
  EXPECT_FALSE(started());
  EXPECT_EQ(found.at("content/1/a.md").day, "2026-03-03");
  EXPECT_FALSE(found.at("content/1/b.md").committed());
}

// A folder with these names in it is a repository for git, unless it is told of another.
TEST_F(HostileRepository, IsNotTheCourseItself) {
  write("course/config", settings_ + "[core]\n\tbare = false\n\tworktree = .\n");
  write("course/HEAD", "ref: refs/heads/main\n");
  write("course/objects/a", "");
  write("course/refs/a", "");
  commit("2026-03-03T12:00:00Z");
  fs::permissions(elsewhere_.path(), fs::perms::all);
  const LastChanges found = changes();
  EXPECT_FALSE(started());
  EXPECT_EQ(found.at("content/1/a.md").day, "2026-03-03");
}

TEST_F(LastChanged, IsKnownInAnotherWorkTree) {
  write("course/content/1/a.md", "a");
  commit("2026-03-03T12:00:00Z");
  const TemporaryFolder other;
  git({"worktree", "add", "--quiet", (other.path() / "tree").string()});
  const LastChanges found = last_changed(other.path() / "tree" / "course", "content").changes;
  EXPECT_EQ(found.at("content/1/a.md").day, "2026-03-03");
}

TEST_F(LastChanged, IsNotLookedForInACeilingFromBelow) {
  write("course/content/1/a.md", "a");
  commit("2026-03-03T12:00:00Z");
  setenv("GIT_CEILING_DIRECTORIES", ("/none:" + folder_.path().string()).c_str(), 1);
  const LastChanges below = changes(), within = last_changed(folder_.path(), "course").changes;
  unsetenv("GIT_CEILING_DIRECTORIES");
  EXPECT_TRUE(below.empty());
  EXPECT_EQ(within.at("course/content/1/a.md").day, "2026-03-03");
}

// What a user has set up changes nothing.
TEST_F(LastChanged, IsTheSameForEveryUser) {
  write("course/content/1/a.md", "a");
  commit("2026-03-03T12:00:00Z");
  const TemporaryFolder home;
  write_file(home.path() / "config", "[log]\n\tshowRoot = false\n\tdate = raw\n");
  setenv("GIT_CONFIG_GLOBAL", (home.path() / "config").c_str(), 1);
  const LastChanges found = changes();
  unsetenv("GIT_CONFIG_GLOBAL");
  EXPECT_EQ(found.at("content/1/a.md").day, "2026-03-03");
}

}  // namespace
}  // namespace mjcourse
