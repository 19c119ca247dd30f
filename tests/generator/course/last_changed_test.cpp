#include "course/last_changed.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "base/files.h"
#include "base/subprocess.h"
#include "base/temporary_folder.h"

namespace mjcourse {
namespace {

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
  LastChanges changes(const std::string& course = "course") const {
    return last_changed(folder_.path() / course, "content");
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
  // The day of who made it, and the moment for all.
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

TEST_F(LastChanged, IsNotGuessedFromAShallowClone) {
  write("course/content/1/a.md", "a");
  commit("2026-03-03T12:00:00Z");
  write("course/content/1/b.md", "b");
  commit("2026-03-04T12:00:00Z");
  git({"clone", "--quiet", "--depth=1", "file://" + folder_.path().string(), "shallow"});
  EXPECT_TRUE(changes("shallow/course").empty());
  git({"clone", "--quiet", "file://" + folder_.path().string(), "whole"});
  EXPECT_EQ(changes("whole/course").at("content/1/a.md").day, "2026-03-03");
}

TEST(LastChangedWithoutGit, IsUnknown) {
  const TemporaryFolder folder;
  write_file(folder.path() / "content/a.md", "a");
  EXPECT_TRUE(last_changed(folder.path(), "content").empty());
}

}  // namespace
}  // namespace mjcourse
