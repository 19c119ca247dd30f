#include "base/out_folder.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <ostream>
#include <system_error>

#include "base/beneath.h"
#include "base/files.h"
#include "base/temporary_folder.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

// A folder to write into, beside a file and a folder that are somebody's.
class OutFolderTest : public testing::Test {
 protected:
  OutFolderTest() {
    fs::create_directory(out());
    fs::create_directory(elsewhere());
    write_file(theirs(), "as it was");
  }
  fs::path out() const { return folder_.path() / "out"; }
  fs::path elsewhere() const { return folder_.path() / "elsewhere"; }
  fs::path theirs() const { return folder_.path() / "theirs"; }
  static std::string text(const fs::path& file) { return read_file(file).value_or("not there"); }

  // What is thrown where something is written under `name`; "" where it was written.
  std::string refusal(const std::string& name) const {
    std::string said;
    try {
      OutFolder(out()).write(name, "new");
    } catch (const RefusedPath& refused) {
      said = refused.what();
    } catch (const std::system_error& error) {
      said = error.what();
    }
    EXPECT_EQ(text(theirs()), "as it was") << name;
    EXPECT_TRUE(fs::is_empty(elsewhere())) << name;
    return said;
  }

  TemporaryFolder folder_;
};

TEST_F(OutFolderTest, MakesFilesAndTheirFolders) {
  const OutFolder folder(out());
  folder.write("a.txt", "a");
  folder.write("deep/er/b.txt", "b");
  folder.write("deep/c.txt", [](std::ostream& file) { file << "one" << 'c'; });
  folder.inner("deep/./er").write("d.txt", "d");
  folder.inner(".").write("e.txt", "");
  EXPECT_EQ(text(out() / "a.txt"), "a");
  EXPECT_EQ(text(out() / "deep/er/b.txt"), "b");
  EXPECT_EQ(text(out() / "deep/c.txt"), "onec");
  EXPECT_EQ(text(out() / "deep/er/d.txt"), "d");
  EXPECT_EQ(text(out() / "e.txt"), "");
  EXPECT_EQ(folder.inner("deep/er").path(), out() / "deep/er");
}

TEST_F(OutFolderTest, IsLeftByNoName) {
  const std::string why = " leads out of " + out().string() + ", so nothing is written there";
  for (const char* name : {"..", "../theirs", "a/../../theirs", "a/..", "./../theirs"}) {
    EXPECT_EQ(refusal(name), (out() / name).string() + why);
  }
  EXPECT_EQ(refusal(theirs()), theirs().string() + why);
  const OutFolder folder(out());
  EXPECT_THROW(folder.inner("../elsewhere"), RefusedPath);
  EXPECT_THROW(folder.move("../theirs", folder), RefusedPath);
  for (const char* name : {"", ".", "./"}) {
    EXPECT_EQ(refusal(name), out().string() + ": Is a directory");
  }
}

TEST_F(OutFolderTest, TellsOfFilesAndMakesNone) {
  const OutFolder folder(out());
  folder.write("deep/a.txt", "a");
  EXPECT_TRUE(folder.holds_file("deep/a.txt"));
  for (const char* name : {"", "deep", "b.txt", "deep/b.txt", "missing/er/b.txt"}) {
    EXPECT_FALSE(folder.holds_file(name)) << name;
  }
  EXPECT_FALSE(fs::exists(out() / "missing"));
  fs::create_symlink("deep", out() / "inside");
  fs::create_symlink(theirs(), out() / "file");
  fs::create_symlink(elsewhere() / "none", out() / "dangling");
  const auto said = [&](const std::string& name) -> std::string {
    try {
      return folder.holds_file(name) ? "there" : "not there";
    } catch (const RefusedPath& refused) {
      return refused.what();
    }
  };
  const std::string why = " is a link, so nothing is written there";
  EXPECT_EQ(said("inside/a.txt"), out() / "inside" += why);
  EXPECT_EQ(said("inside"), out() / "inside" += why);
  EXPECT_EQ(said("file"), out() / "file" += why);
  EXPECT_EQ(said("dangling"), out() / "dangling" += why);
  EXPECT_EQ(said("dangling/a"), out() / "dangling" += why);
  EXPECT_THROW(folder.holds_file("deep/a.txt/b"), std::system_error);
}

TEST_F(OutFolderTest, FollowsNoLinkOnTheWay) {
  fs::create_directory(out() / "inside");
  fs::create_symlink(elsewhere(), out() / "absolute");
  fs::create_symlink("../elsewhere", out() / "relative");
  fs::create_symlink("inside", out() / "stays");
  fs::create_symlink("../nowhere", out() / "dangling");
  fs::create_symlink("..", out() / "inside" / "above");
  for (const char* link : {"absolute", "relative", "stays", "dangling", "inside/above"}) {
    EXPECT_EQ(refusal(std::string(link) + "/a"),
              (out() / link).string() + " is a link, so nothing is written there");
    EXPECT_THROW(OutFolder(out()).inner(link), RefusedPath);
  }
  EXPECT_FALSE(fs::exists(folder_.path() / "nowhere"));
}

// What lies under the name is gone, and what it led to, or shares its bytes with, is as it was.
TEST_F(OutFolderTest, ReplacesWhatLiesThere) {
  fs::create_symlink(theirs(), out() / "link");
  fs::create_symlink("nowhere", out() / "dangling");
  fs::create_hard_link(theirs(), out() / "shared");
  ASSERT_EQ(mkfifo((out() / "pipe").c_str(), 0600), 0);
  for (const char* name : {"link", "dangling", "shared", "pipe"}) {
    EXPECT_EQ(refusal(name), "");
    EXPECT_TRUE(fs::is_regular_file(fs::symlink_status(out() / name))) << name;
    EXPECT_EQ(text(out() / name), "new") << name;
  }
  EXPECT_FALSE(fs::exists(out() / "nowhere"));
  // The modes of files stay as they were.
  fs::permissions(out() / "shared", fs::perms::owner_read | fs::perms::owner_write);
  EXPECT_EQ(refusal("shared"), "");
  EXPECT_EQ(fs::status(out() / "shared").permissions(),
            fs::perms::owner_read | fs::perms::owner_write);
  fs::create_directory(out() / "folder");
  EXPECT_EQ(refusal("folder"), (out() / "folder").string() + ": Is a directory");
  EXPECT_EQ(refusal("shared/a"), (out() / "shared").string() + ": Not a directory");
}

TEST_F(OutFolderTest, SaysWhatAWriterCouldNotWrite) {
  const auto fails = [](std::ostream& file) { file.setstate(std::ios::badbit); };
  EXPECT_THROW(OutFolder(out()).write("a", fails), std::system_error);
  EXPECT_THROW(OutFolder(out() / "missing"), std::system_error);
}

TEST_F(OutFolderTest, StaysTheFolderThatWasOpened) {
  const OutFolder folder(out());
  fs::rename(out(), folder_.path() / "renamed");
  fs::create_symlink(elsewhere(), out());
  folder.write("a", "a");
  EXPECT_TRUE(fs::is_empty(elsewhere()));
  EXPECT_EQ(text(folder_.path() / "renamed" / "a"), "a");
}

TEST_F(OutFolderTest, MovesToAFreePlaceInAnother) {
  fs::create_directories(out() / "deep");
  fs::create_symlink("/nowhere", out() / "deep" / "link");
  write_file(out() / "taken", "mine");
  write_file(elsewhere() / "taken", "theirs");
  const OutFolder from(out()), to(elsewhere());
  from.move("deep/link", to);
  EXPECT_EQ(fs::read_symlink(elsewhere() / "deep" / "link"), "/nowhere");
  EXPECT_THROW(from.move("taken", to), std::system_error);
  EXPECT_EQ(text(elsewhere() / "taken"), "theirs");
  fs::create_symlink(folder_.path(), elsewhere() / "way");
  write_file(out() / "way" / "x", "x");
  EXPECT_THROW(from.move("way/x", to), RefusedPath);
}

// A course that is a stranger's, which is out().
class OutPlaceTest : public OutFolderTest {
 protected:
  // Where the path leads, and how the course calls that: "/…/out/build/site build/site".
  std::string found(const fs::path& path) const {
    const OutPath place = find_out_path(path, out());
    return place.path.string() + " " + place.inside + (place.is_link ? ", a link" : "");
  }
  // Where the place was opened, or why not.
  std::string opened(const fs::path& place) const {
    try {
      return open_out_place(place, out()).path();
    } catch (const RefusedPath& refused) {
      return refused.what();
    }
  }
};

TEST_F(OutPlaceTest, IsFoundAsTheKernelFindsIt) {
  fs::create_directories(out() / "deep" / "er");
  fs::create_symlink(out() / "deep" / "er", folder_.path() / "er");
  const std::string base = folder_.path();
  EXPECT_EQ(found(out() / "build/site"), base + "/out/build/site build/site");
  EXPECT_EQ(found(out() / "build//./site/"), base + "/out/build/site build/site");
  EXPECT_EQ(found(out() / "missing/../build"), base + "/out/build build");
  EXPECT_EQ(found(folder_.path() / "er" / "../a"), base + "/out/deep/a deep/a");
  EXPECT_EQ(found(out()), base + "/out ");
  EXPECT_EQ(found(out() / ""), base + "/out ");
  EXPECT_EQ(found(out() / "../elsewhere/a"), base + "/elsewhere/a ");
  EXPECT_EQ(found(base + "/out-2/a"), base + "/out-2/a ");
}

TEST_F(OutPlaceTest, IsReachedThroughNoLinkOfTheCourse) {
  fs::create_symlink(elsewhere(), out() / "link");
  fs::create_directory(out() / "inside");
  fs::create_symlink("inside", out() / "stays");
  fs::create_symlink("..", out() / "inside" / "above");
  for (const char* link : {"link", "stays", "inside/above"}) {
    const std::string said = std::string(link) + " is a link, so nothing is written there";
    EXPECT_EQ(opened(out() / link), said);
    EXPECT_EQ(opened(out() / link / "deep/site"), said);
  }
  // By way of the user's.
  fs::create_symlink(out(), folder_.path() / "mine");
  fs::create_symlink("mine/link", folder_.path() / "chain");
  EXPECT_EQ(opened(folder_.path() / "mine/link/site"),
            "link is a link, so nothing is written there");
  EXPECT_EQ(opened(folder_.path() / "chain/site"), "link is a link, so nothing is written there");
  EXPECT_EQ(opened(folder_.path() / "mine/build/site"), out() / "build/site");
  EXPECT_TRUE(fs::is_directory(out() / "build"));
  EXPECT_TRUE(fs::is_empty(elsewhere()));
}

// A change brings links beside the course as well, where that is a folder of a repository.
TEST_F(OutPlaceTest, IsReachedThroughNoLinkOfTheCheckout) {
  fs::create_directory(folder_.path() / ".git");
  fs::create_symlink(elsewhere(), folder_.path() / "build");
  fs::create_symlink(elsewhere(), out() / "link");
  const std::string build = folder_.path() / "build";
  EXPECT_EQ(opened(folder_.path() / "build"), build + " is a link, so nothing is written there");
  EXPECT_EQ(opened(out() / "../build/site"), build + " is a link, so nothing is written there");
  EXPECT_EQ(opened(out() / "link/site"), "link is a link, so nothing is written there");
  EXPECT_EQ(opened(out() / "deep/site"), out() / "deep/site");
  EXPECT_EQ(opened(folder_.path() / "site"), folder_.path() / "site");
  EXPECT_TRUE(fs::is_empty(elsewhere()));
}

TEST_F(OutPlaceTest, IsWhereALinkOfTheUsersLeads) {
  fs::create_symlink("elsewhere", folder_.path() / "mine");
  fs::create_symlink(elsewhere() / "later", folder_.path() / "dangling");
  fs::create_symlink("circle", folder_.path() / "circle");
  EXPECT_EQ(opened(folder_.path() / "mine"), elsewhere());
  EXPECT_EQ(opened(folder_.path() / "mine/deep/site/"), elsewhere() / "deep/site");
  EXPECT_EQ(opened(folder_.path() / "dangling"), elsewhere() / "later");
  EXPECT_TRUE(fs::is_directory(elsewhere() / "deep"));
  EXPECT_THROW(opened(folder_.path() / "circle"), std::system_error);
}

}  // namespace
}  // namespace mjcourse
