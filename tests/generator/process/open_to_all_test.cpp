#include "process/open_to_all.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "base/files.h"
#include "base/temporary_folder.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

class OpenToAll : public testing::Test {
 protected:
  OpenToAll() {
    write_file(root() / "course/models/a.xml", "<mujoco/>");
    mode("", 0755);
    mode("course", 0755);
    mode("course/models", 0755);
    mode("course/models/a.xml", 0644);
  }
  const fs::path& root() const { return folder_.path(); }
  void mode(const std::string& name, mode_t mode) const {
    ASSERT_EQ(chmod((root() / name).c_str(), mode), 0);
  }
  bool reached(const std::string& name) const { return can_be_reached_by_all(root() / name); }
  bool read(const std::string& name) const { return can_be_read_by_all(root() / name); }

  TemporaryFolder folder_;
};

TEST_F(OpenToAll, IsWhatEverybodyMayRead) {
  EXPECT_TRUE(reached("course/models/a.xml"));
  EXPECT_TRUE(read("course/models/a.xml"));
  EXPECT_TRUE(read("course"));
}

TEST_F(OpenToAll, IsNothingBelowAClosedFolder) {
  mode("course", 0750);
  EXPECT_FALSE(reached("course/models/a.xml"));
  EXPECT_FALSE(read("course/models"));
  EXPECT_TRUE(reached("course"));
  EXPECT_FALSE(read("course"));
}

// A user who may go through a folder need not be able to list it.
TEST_F(OpenToAll, IsReachedThroughAFolderThatCannotBeListed) {
  mode("course", 0711);
  EXPECT_TRUE(read("course/models/a.xml"));
  EXPECT_FALSE(read("course"));
}

TEST_F(OpenToAll, IsNoFolderWithAClosedFileInIt) {
  mode("course/models/a.xml", 0600);
  EXPECT_TRUE(reached("course/models/a.xml"));
  EXPECT_FALSE(read("course/models/a.xml"));
  EXPECT_FALSE(read("course"));
}

TEST_F(OpenToAll, LooksWhereALinkLeads) {
  write_file(root() / "closed/b.xml", "<mujoco/>");
  mode("closed", 0700);
  mode("closed/b.xml", 0644);
  EXPECT_TRUE(read("course"));
  fs::create_symlink(root() / "closed/b.xml", root() / "course/models/b.xml");
  EXPECT_FALSE(reached("course/models/b.xml"));
  EXPECT_FALSE(read("course"));
  mode("closed", 0755);
  EXPECT_TRUE(read("course"));
}

TEST_F(OpenToAll, IsWhatIsNotThere) {
  EXPECT_TRUE(read("course/models/none.xml"));
  EXPECT_TRUE(read("none"));
  mode("course", 0750);
  EXPECT_FALSE(read("course/models/none.xml"));
}

TEST_F(OpenToAll, IsNoFolderOfVeryManyFiles) {
  const fs::path many = root() / "many";
  fs::create_directories(many);
  mode("many", 0755);
  for (int i = 0; i < 5000; ++i) fs::create_symlink("/usr", many / std::to_string(i));
  EXPECT_TRUE(read("many"));
  fs::create_symlink("/usr", many / "one-more");
  EXPECT_FALSE(read("many"));
}

}  // namespace
}  // namespace mjcourse
