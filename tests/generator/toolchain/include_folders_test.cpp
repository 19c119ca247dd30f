#include "toolchain/include_folders.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "base/files.h"
#include "base/temporary_folder.h"

namespace mjcourse {
namespace {

class IncludeFoldersTest : public testing::Test {
 protected:
  IncludeFoldersTest() {
    write_file(helper_ / "mjcourse/mjcourse.hpp", "");
    write_file(helper_ / "mjcourse/handlers.cpp", "");
  }
  IncludeFolders folders() const { return include_folders_of(examples_, helper_); }

  TemporaryFolder folder_;
  std::filesystem::path examples_ = folder_.path() / "course/examples";
  std::filesystem::path own_ = examples_ / "include";
  std::filesystem::path helper_ = folder_.path() / "tool/include";
};

TEST_F(IncludeFoldersTest, OfACourseWithoutHeadersAreTheTools) {
  EXPECT_EQ(folders(), (IncludeFolders{own_, helper_}));
  EXPECT_EQ(folder_with(kHelperHeader, folders()), helper_);
  EXPECT_EQ(handlers_source(folders()), helper_ / "mjcourse/handlers.cpp");
}

TEST_F(IncludeFoldersTest, OfACourseWithOtherHeadersAreBoth) {
  write_file(own_ / "kit.h", "");
  EXPECT_EQ(folder_with("kit.h", folders()), own_);
  EXPECT_EQ(folder_with(kHelperHeader, folders()), helper_);
}

TEST_F(IncludeFoldersTest, OfACourseWithItsOwnHelperHeaderAreItsOwn) {
  write_file(own_ / "mjcourse/mjcourse.hpp", "");
  EXPECT_EQ(folders(), IncludeFolders{own_});
  EXPECT_EQ(handlers_source(folders()), "");
}

// As a compiler would wait at a pipe, in vain.
TEST_F(IncludeFoldersTest, WithAPipeAreTheTools) {
  std::filesystem::create_directories(own_ / "mjcourse");
  ASSERT_EQ(mkfifo((own_ / "mjcourse/mjcourse.hpp").c_str(), 0600), 0);
  EXPECT_EQ(folders(), IncludeFolders{helper_});
}

TEST_F(IncludeFoldersTest, WithAPipeInAFolderAreTheTools) {
  std::filesystem::create_directories(own_ / "deep/er");
  ASSERT_EQ(mkfifo((own_ / "deep/er/a.hpp").c_str(), 0600), 0);
  EXPECT_EQ(folders(), IncludeFolders{helper_});
}

}  // namespace
}  // namespace mjcourse
