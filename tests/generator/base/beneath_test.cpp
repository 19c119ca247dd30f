#include "base/beneath.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

#include "base/files.h"
#include "base/replace_file.h"
#include "base/stopwatch.h"
#include "base/temporary_folder.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;
using Way = Beneath::Way;

constexpr const char* kOutside =
    "leads out of the course; a course is made of its own files: put a copy there, or a link that "
    "stays inside of the course";

// A course beside a secret; each test with the kernel's way and by hand.
class BeneathTest : public testing::TestWithParam<Way> {
 protected:
  BeneathTest() {
    write_file(folder_.path() / "secret", "a secret");
    write_file(course() / "models" / "real.xml", "the text");
    write_file(course() / ".git" / "config", "a token");
  }
  fs::path course() const { return folder_.path() / "course"; }
  void link(const fs::path& target, const std::string& name) const {
    fs::create_symlink(target, course() / name);
  }
  // The bytes, or why not.
  std::string read(const std::string& path) const {
    const auto bytes = files_.read(path);
    return bytes ? *bytes : bytes.error();
  }

  // "why; cure"; empty for what is read or is absent.
  std::string refusal(const std::string& path) const {
    const auto refused = files_.refusal(path);
    return refused ? refused->why + "; " + refused->cure : "";
  }

  TemporaryFolder folder_;
  DiskFiles files_{folder_.path() / "course", GetParam()};
};

TEST_P(BeneathTest, FollowsLinksThatStayInside) {
  link("models/real.xml", "plain.xml");
  link("plain.xml", "chain.xml");
  link("models", "folder");
  link("../models/real.xml", "models/climbing.xml");
  link(course() / "models" / "real.xml", "absolute.xml");
  for (const char* path :
       {"models/real.xml", "plain.xml", "chain.xml", "folder/real.xml", "models/climbing.xml",
        "absolute.xml", "folder/../plain.xml", "./models//real.xml"}) {
    EXPECT_EQ(read(path), "the text") << path;
    EXPECT_TRUE(files_.exists(path)) << path;
    EXPECT_EQ(refusal(path), "") << path;
  }
  EXPECT_TRUE(files_.is_folder("folder"));
  EXPECT_EQ(files_.list("folder"), (std::vector<std::string>{"climbing.xml", "real.xml"}));
}

TEST_P(BeneathTest, RefusesWhatLeadsOut) {
  link("../secret", "relative");
  link(folder_.path() / "secret", "absolute");
  link("relative", "chain");
  link("..", "parent");
  link("/etc", "models/system");
  link("models/../../secret", "winding");
  link("../nothing", "dangling");
  link("/proc/self/environ", "magic");
  link(course().string() + "/../secret", "back");
  for (const std::string path :
       {"relative", "absolute", "chain", "parent/secret", "models/system/passwd", "winding",
        "dangling", "magic", "back", "../secret", "models/../../secret", "/etc/passwd"}) {
    EXPECT_EQ(read(path), path + ": leads out of the course");
    EXPECT_EQ(refusal(path), kOutside) << path;
    EXPECT_TRUE(files_.exists(path)) << "it is not absent: " << path;
  }
  EXPECT_EQ(files_.list("models/system"), std::vector<std::string>{});
  EXPECT_EQ(files_.list("parent"), std::vector<std::string>{});
}

TEST_P(BeneathTest, TellsWhatIsAbsentFromWhatIsRefused) {
  link("models/none.xml", "dangling");
  for (const std::string path : {"none", "models/none.xml", "dangling"}) {
    EXPECT_EQ(read(path), path + ": No such file or directory");
    EXPECT_EQ(refusal(path), "");
    EXPECT_FALSE(files_.exists(path));
  }
}

TEST_P(BeneathTest, RefusesWhatIsGits) {
  link(".git/config", "config");
  link(".git", "folder");
  const std::string why = "lies in .git, which is no part of the course";
  for (const std::string path :
       {".git/config", "config", "folder/config", "models/../.git/config"}) {
    EXPECT_EQ(read(path), path + ": " + why);
  }
  EXPECT_EQ(refusal("folder"),
            why + "; put a copy of it into another folder of the course, and name that");
  write_file(course() / ".gitignore", "build");
  EXPECT_EQ(read(".gitignore"), "build");
  for (const DiskFiles::Entry& entry : files_.below("")) {
    EXPECT_FALSE(entry.path.starts_with(".git/")) << entry.path;
  }
}

TEST_P(BeneathTest, RefusesWhatLiesInMoreThanAHundredFolders) {
  const auto nested = [](int folders) {
    std::string path = "deep";
    for (int i = 1; i < folders; ++i) path += "/d";
    return path;
  };
  write_file(course() / nested(99) / "in" / "file", "");
  write_file(course() / nested(99) / "file", "read");
  link(nested(50), "half");
  EXPECT_EQ(read(nested(99) + "/file"), "read");
  EXPECT_EQ(files_.list(nested(99)), std::vector<std::string>{"file"});
  const std::string why = "lies in more than 100 folders in each other";
  EXPECT_EQ(read(nested(99) + "/in/file"), nested(99) + "/in/file: " + why);
  EXPECT_EQ(refusal(nested(99) + "/in/file"), why + "; move it into a folder further up");
  EXPECT_EQ(read("half" + nested(50).substr(4) + "/file"), "read");
  EXPECT_EQ(read("half" + nested(50).substr(4) + "/in/file"),
            "half" + nested(50).substr(4) + "/in/file: " + why);
  // It is listed, as what is refused, and is not looked into.
  write_file(course() / nested(102) / "file", "");
  EXPECT_EQ(files_.list_below(nested(98)),
            (std::vector<std::string>{"d/d/d", "d/file", "d/in/file"}));
}

TEST_P(BeneathTest, DoesNotWaitForPipes) {
  ASSERT_EQ(mkfifo((course() / "pipe").c_str(), 0600), 0);
  link("pipe", "to-pipe");
  for (const std::string path : {"pipe", "to-pipe"}) {
    EXPECT_EQ(read(path), path + ": is neither a file nor a folder");
    EXPECT_EQ(refusal(path),
              "is neither a file nor a folder; replace it: a pipe or a device is never read");
  }
}

TEST_P(BeneathTest, EndsInACircle) {
  link("loop", "loop");
  link("b", "a");
  link("a", "b");
  EXPECT_EQ(read("loop"), "loop: is a link that leads in a circle");
  EXPECT_EQ(refusal("a"),
            "is a link that leads in a circle; put the file itself there, or a link to a file of "
            "the course");
}

TEST_P(BeneathTest, ReadsNoMoreThanFitsIntoMemory) {
  write_file(course() / "huge", "");
  fs::resize_file(course() / "huge", std::uintmax_t{1} << 40);
  EXPECT_EQ(read("huge"), "huge: is larger than 256 MiB");
  EXPECT_EQ(refusal("huge"), "is larger than 256 MiB; put a smaller one there");
}

TEST_P(BeneathTest, KnowsTheEndOfALink) {
  link("models", "folder");
  link("folder/real.xml", "x");
  const Beneath beneath(course(), GetParam());
  EXPECT_EQ(beneath.target("x").value(), "models/real.xml");
  EXPECT_EQ(beneath.target("folder").value(), "models");
  EXPECT_EQ(beneath.target("folder/../models/none").value(), "models/none");
  link("../secret", "out");
  EXPECT_TRUE(beneath.target("out").error().is_refused());
}

// While a link is put in the place of a file, over and over, a reader has the one or a refusal.
TEST_P(BeneathTest, IsNotMisledByALinkThatIsPutThereMeanwhile) {
  const fs::path swapped = course() / "swapped", aside = course() / "aside";
  const pid_t swapper = fork();
  if (swapper == 0) {
    for (;;) {
      unlink(aside.c_str());
      if (symlink("../secret", aside.c_str()) != 0) _exit(1);
      rename(aside.c_str(), swapped.c_str());
      const int file = open(aside.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600);
      if (write(file, "ours", 4) != 4) _exit(1);
      close(file);
      rename(aside.c_str(), swapped.c_str());
    }
  }
  int ours = 0, refused = 0, misled = 0;
  const Stopwatch stopwatch;
  const auto has_seen_both = [&] { return ours > 0 && refused > 0; };
  // On a busy machine it may be long until the other one is given a core.
  for (int i = 0; i < 20000 || (!has_seen_both() && stopwatch.seconds() < 60); ++i) {
    const std::string bytes = read("swapped");
    misled += bytes.find("secret") != bytes.npos ? 1 : 0;
    ours += bytes == "ours" ? 1 : 0;
    refused += bytes == "swapped: leads out of the course" ? 1 : 0;
  }
  kill(swapper, SIGKILL);
  waitpid(swapper, nullptr, 0);
  EXPECT_EQ(misled, 0);
  EXPECT_GT(ours, 0);
  EXPECT_GT(refused, 0);
}

INSTANTIATE_TEST_SUITE_P(Ways, BeneathTest, testing::Values(Way::kernel, Way::by_hand));

class WriteBeneath : public testing::Test {
 protected:
  WriteBeneath() { fs::create_directories(folder_.path() / "course"); }
  std::string refusal(const std::string& name) const {
    try {
      replace_file(folder_.path() / "course", name, std::nullopt, "written");
      return "written";
    } catch (const RefusedPath& refused) {
      return refused.what();
    }
  }
  TemporaryFolder folder_;
};

TEST_F(WriteBeneath, GoesThroughNoLinkThatLeadsOut) {
  const fs::path course = folder_.path() / "course";
  fs::create_directory(folder_.path() / "elsewhere");
  fs::create_symlink("../elsewhere", course / "content");
  fs::create_symlink("../elsewhere/new", course / "file");
  fs::create_symlink("inside", course / "link");
  EXPECT_EQ(refusal("content/a.md"), "content/a.md leads out of the course");
  EXPECT_EQ(refusal("content/deep/a.md"), "content/deep/a.md leads out of the course");
  EXPECT_EQ(refusal("file"), "file leads out of the course");
  EXPECT_EQ(refusal(".git/config"), ".git/config lies in .git, which is no part of the course");
  EXPECT_TRUE(fs::is_empty(folder_.path() / "elsewhere"));
  EXPECT_EQ(refusal("link"), "written");
  EXPECT_EQ(DiskFiles(course).read("inside").value(), "written");
}

TEST(NameBeneath, IsWhatFollowsTheFolder) {
  EXPECT_EQ(name_beneath("/a/b", "/a/b/c/../d").value(), "c/../d");
  EXPECT_EQ(name_beneath("/a/b/", "/a/b/c").value(), "c");
  EXPECT_EQ(name_beneath("/a/b", "/a/b").value(), "");
  EXPECT_EQ(name_beneath("/", "/etc").value(), "etc");
  EXPECT_FALSE(name_beneath("/a/b", "/a/bc"));
  EXPECT_FALSE(name_beneath("/a/b", "/a"));
}

}  // namespace
}  // namespace mjcourse
