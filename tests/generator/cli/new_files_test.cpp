#include "cli/new_files.h"

#include <gtest/gtest.h>

#include "base/files.h"
#include "base/plain_name.h"
#include "base/temporary_folder.h"
#include "cli/run.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

class NewFiles : public testing::Test {
 protected:
  void SetUp() override { write_file(folder_.path() / "course.yaml", "old"); }
  std::string bytes_of(const std::string& path) const {
    return DiskFiles(folder_.path()).read(path).value_or("it is not there");
  }
  // What was in the way; "" where all was written.
  std::string written(const std::vector<NewFile>& files) const {
    const auto result = write_new_files(folder_.path(), files);
    if (result) return "";
    EXPECT_EQ(result.error().code, kCourseErrors);
    return result.error().message + "; " + result.error().cure;
  }

  TemporaryFolder folder_;
};

TEST_F(NewFiles, AreWritten) {
  EXPECT_EQ(written({{"a/b.md", "text"}, {"course.yaml", "new", "old"}}), "");
  EXPECT_EQ(bytes_of("a/b.md"), "text");
  EXPECT_EQ(bytes_of("course.yaml"), "new");
}

TEST_F(NewFiles, OverwriteNothing) {
  write_file(folder_.path() / "b.md", "mine");
  EXPECT_EQ(written({{"a.md", "text"}, {"b.md", "text"}}),
            "b.md is there already, so nothing was written; choose another name, or move that file "
            "away");
  EXPECT_EQ(bytes_of("b.md"), "mine");
  EXPECT_FALSE(fs::exists(folder_.path() / "a.md"));
}

TEST_F(NewFiles, HaveNamesThatADiskTakes) {
  const std::string name(kLongestName + 1, 'a');
  for (const std::string& path : {name, name + "/b.md", "b/" + name}) {
    const auto result = write_new_files(folder_.path(), {{"first.md", "text"}, {path, "text"}});
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, kWrongUsage);
    EXPECT_EQ(result.error().message, "`" + name + "` is too long for a name on the disk");
    EXPECT_EQ(result.error().cure, "choose a shorter name");
    EXPECT_EQ(bytes_of("first.md"), "it is not there");
  }
  EXPECT_EQ(written({{std::string(kLongestName, 'a'), "text"}}), "");
}

TEST_F(NewFiles, DoNotFollowALinkToNowhere) {
  fs::create_symlink("elsewhere.md", folder_.path() / "b.md");
  EXPECT_NE(written({{"b.md", "text"}}), "");
  EXPECT_FALSE(fs::exists(folder_.path() / "elsewhere.md"));
}

TEST_F(NewFiles, AreRemovedWhereTheLastCannotBeWritten) {
  EXPECT_EQ(written({{"a.md", "text"}, {"course.yaml", "new", "older"}}),
            "course.yaml changed meanwhile, so nothing was written; run it again");
  EXPECT_EQ(bytes_of("course.yaml"), "old");
  EXPECT_FALSE(fs::exists(folder_.path() / "a.md"));
}

}  // namespace
}  // namespace mjcourse
