#include "base/files.h"

#include <gtest/gtest.h>

#include <system_error>

#include "base/temporary_folder.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;
using Names = std::vector<std::string>;

TEST(MemoryFiles, HoldsWhatItWasGiven) {
  const MemoryFiles files({{"a/x.md", "one"}, {"a/y.md", ""}, {"a/b/z.md", "three"}});
  EXPECT_EQ(files.read("a/x.md").value(), "one");
  EXPECT_EQ(files.read("a/y.md").value(), "");
  EXPECT_TRUE(files.exists("a/b/z.md"));
  EXPECT_FALSE(files.exists("a/b"));
}

TEST(MemoryFiles, ListsAFolderButNotTheFoldersInIt) {
  const MemoryFiles files({{"a/y", ""}, {"a/x", ""}, {"a/b/z", ""}, {"ab/w", ""}});
  EXPECT_EQ(files.list("a"), (Names{"x", "y"}));
  EXPECT_EQ(files.list("nowhere"), Names{});
}

TEST(MemoryFiles, ListsWhatLiesDeeperToo) {
  const MemoryFiles files({{"a/y", ""}, {"a/b/c/z", ""}, {"a/b/x", ""}, {"ab/w", ""}});
  EXPECT_EQ(files.list_below("a"), (Names{"b/c/z", "b/x", "y"}));
  EXPECT_EQ(files.list_below("nowhere"), Names{});
}

TEST(MemoryFiles, NamesTheFileThatIsNotThere) {
  EXPECT_EQ(MemoryFiles({}).read("models/x.xml").error(),
            "models/x.xml: No such file or directory");
}

class DiskFilesTest : public testing::Test {
 protected:
  TemporaryFolder folder_;
  DiskFiles files_{folder_.path()};
};

TEST_F(DiskFilesTest, ReadsTheBytesThatWereWritten) {
  const std::string bytes("a\r\n\0\xFFz", 6);
  write_file(folder_.path() / "deep" / "er" / "x.bin", bytes);
  EXPECT_EQ(files_.read("deep/er/x.bin").value(), bytes);
  EXPECT_TRUE(files_.exists("deep/er/x.bin"));
}

TEST_F(DiskFilesTest, ListsWhatLiesDeeperToo) {
  for (const char* name : {"a/y", "a/b/c/z", "a/b/x", "ab/w"})
    write_file(folder_.path() / name, "");
  fs::create_directory_symlink("b", folder_.path() / "a/link");
  EXPECT_EQ(files_.list_below("a"), (Names{"b/c/z", "b/x", "y"}));
  EXPECT_EQ(files_.list_below("a/b"), (Names{"c/z", "x"}));
  EXPECT_EQ(files_.list_below("nowhere"), Names{});
}

TEST_F(DiskFilesTest, ReadsAnEmptyFileAsNothing) {
  write_file(folder_.path() / "empty", "");
  EXPECT_EQ(files_.read("empty").value(), "");
}

TEST_F(DiskFilesTest, ReplacesAFileThatWasLonger) {
  write_file(folder_.path() / "x", "a long text");
  write_file(folder_.path() / "x", "short");
  EXPECT_EQ(files_.read("x").value(), "short");
}

TEST_F(DiskFilesTest, SaysWhyAFileCannotBeRead) {
  fs::create_directory(folder_.path() / "models");
  EXPECT_EQ(files_.read("models/x.xml").error(), "models/x.xml: No such file or directory");
  EXPECT_EQ(files_.read("models").error(), "models: is a folder, not a file");
  write_file(folder_.path() / "plain", "");
  EXPECT_EQ(files_.read("plain/x.xml").error(), "plain/x.xml: Not a directory");
}

TEST_F(DiskFilesTest, ListsRegularFilesInOrder) {
  for (const char* name : {"b.md", "a.md", "c/d.md"}) write_file(folder_.path() / name, "");
  EXPECT_EQ(files_.list("."), (Names{"a.md", "b.md"}));
  EXPECT_EQ(files_.list("nowhere"), Names{});
  EXPECT_FALSE(files_.exists("c"));
}

TEST_F(DiskFilesTest, FollowsLinksToFiles) {
  write_file(folder_.path() / "real.md", "text");
  fs::create_symlink("real.md", folder_.path() / "link.md");
  EXPECT_EQ(files_.read("link.md").value(), "text");
  EXPECT_EQ(files_.list("."), (Names{"link.md", "real.md"}));
}

TEST(WriteFile, ThrowsWithThePath) {
  try {
    write_file("/dev/full", "more than it takes");
    FAIL() << "the disk is full";
  } catch (const std::system_error& error) {
    EXPECT_STREQ(error.what(), "/dev/full: No space left on device");
  }
}

TEST(TemporaryFolder, IsGoneWithEverythingInIt) {
  fs::path first, second;
  {
    const TemporaryFolder one, two;
    first = one.path();
    second = two.path();
    EXPECT_NE(first, second);
    write_file(first / "a" / "b", "c");
    EXPECT_TRUE(fs::is_directory(second));
  }
  EXPECT_FALSE(fs::exists(first));
  EXPECT_FALSE(fs::exists(second));
}

TEST(MemoryFiles, NamesFolders) {
  const MemoryFiles files({{"a/b/c", ""}, {"a/d", ""}, {"a/e/f", ""}, {"g", ""}});
  EXPECT_EQ(files.folders("a"), (std::vector<std::string>{"b", "e"}));
  EXPECT_TRUE(files.folders("g").empty());
}

TEST(ReadAgain, NamesTheFileThatIsLost) {
  const MemoryFiles files({{"a", "text"}});
  EXPECT_EQ(read_again(files, "a"), "text");
  try {
    read_again(files, "b");
    FAIL() << "nothing is thrown";
  } catch (const LostFile& lost) {
    EXPECT_STREQ(lost.what(), "b: No such file or directory");
  }
}

}  // namespace
}  // namespace mjcourse
