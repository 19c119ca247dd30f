#include "base/replace_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <system_error>

#include "base/beneath.h"
#include "base/files.h"
#include "base/temporary_folder.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

class ReplaceFile : public testing::Test {
 protected:
  fs::path path(const std::string& name) const { return folder_.path() / "course" / name; }
  void write(const std::string& name, const std::string& bytes) const {
    write_file(path(name), bytes);
  }
  std::string read(const std::string& name) const {
    return DiskFiles(folder_.path() / "course").read(name).value();
  }
  // Nothing is left beside the files, hidden ones counted.
  std::size_t files() const {
    std::size_t count = 0;
    for (const auto& entry : fs::directory_iterator(folder_.path() / "course")) {
      static_cast<void>(entry);
      ++count;
    }
    return count;
  }

  TemporaryFolder folder_;
};

TEST_F(ReplaceFile, KeepsTheMode) {
  write("a", "old");
  fs::permissions(path("a"), fs::perms(0640));
  EXPECT_TRUE(replace_file(folder_.path() / "course", "a", "old", "new"));
  EXPECT_EQ(read("a"), "new");
  EXPECT_EQ(fs::status(path("a")).permissions(), fs::perms(0640));
  EXPECT_EQ(files(), 1u);
}

TEST_F(ReplaceFile, MakesAFileAndItsFolders) {
  const mode_t mask = umask(022);
  EXPECT_TRUE(replace_file(folder_.path() / "course", "b/c", std::nullopt, "new"));
  umask(mask);
  EXPECT_EQ(read("b/c"), "new");
  EXPECT_EQ(fs::status(path("b/c")).permissions(), fs::perms(0644));
}

TEST_F(ReplaceFile, LeavesAFileThatChangedMeanwhile) {
  write("a", "newer");
  EXPECT_FALSE(replace_file(folder_.path() / "course", "a", "old", "new"));
  EXPECT_FALSE(replace_file(folder_.path() / "course", "a", std::nullopt, "new"));
  EXPECT_EQ(read("a"), "newer");
  fs::remove(path("a"));
  EXPECT_FALSE(replace_file(folder_.path() / "course", "a", "old", "new"));
  EXPECT_EQ(files(), 0u);
}

TEST_F(ReplaceFile, ReplacesWhatALinkLeadsTo) {
  write("there/a", "old");
  fs::create_symlink("there/a", path("link"));
  EXPECT_TRUE(replace_file(folder_.path() / "course", "link", "old", "new"));
  EXPECT_TRUE(fs::is_symlink(path("link")));
  EXPECT_EQ(read("there/a"), "new");
  EXPECT_FALSE(fs::is_symlink(path("there/a")));
}

TEST_F(ReplaceFile, TellsWhatItCannotDoAndLeavesNothingBehind) {
  write("a", "no folder");
  EXPECT_THROW(replace_file(folder_.path() / "course", "a/b", std::nullopt, "new"),
               std::system_error);
  fs::create_symlink("loop", path("loop"));
  EXPECT_THROW(replace_file(folder_.path() / "course", "loop", "old", "new"), RefusedPath);
  EXPECT_EQ(files(), 2u);
}

}  // namespace
}  // namespace mjcourse
