#include "base/remove_folder.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>

#include "base/descriptor.h"
#include "base/files.h"
#include "base/temporary_folder.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

constexpr uid_t kOrdinary = 54321;  // a user who has nothing
// More than a process has files open, and with a path that is longer than any may be.
constexpr int kDeep = 200;
const std::string kLongName(30, 'd');

// A folder of each mode with a file and a folder in it, and these in each other.
void make_closed_folders(const fs::path& place) {
  for (const char* name : {"0", "1", "100", "200", "300", "400", "500", "600", "700", "1777"}) {
    const fs::path folder = place / name, inner = folder / "2" / "inner";
    write_file(inner / "file", "x");
    fs::create_symlink(place, inner / "link");
    for (const fs::path& one : {inner, inner.parent_path(), folder}) {
      ASSERT_EQ(chmod(one.c_str(), static_cast<mode_t>(std::stoi(name, nullptr, 8))), 0);
    }
  }
}

void make_deep_folder(const fs::path& place) {
  Descriptor folder(open(place.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC));
  for (int i = 0; i < kDeep; ++i) {
    ASSERT_EQ(mkdirat(folder.get(), kLongName.c_str(), 0700), 0);
    folder = Descriptor(openat(folder.get(), kLongName.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC));
    ASSERT_TRUE(folder.is_open());
  }
}

// In a process of its own: as which user, and with how many files open at most.
[[noreturn]] void make_and_remove(void (*make)(const fs::path&), uid_t user) {
  rlimit few{64, 64};
  if (setrlimit(RLIMIT_NOFILE, &few) != 0 || (user != getuid() && setuid(user) != 0)) _exit(2);
  umask(0);
  fs::path path;
  {
    const TemporaryFolder folder;
    path = folder.path();
    make(path);
    if (testing::Test::HasFatalFailure() || fs::is_empty(path)) _exit(3);
  }
  _exit(fs::exists(path) ? 1 : 0);
}

uid_t ordinary_user() {
  return getuid() == 0 ? kOrdinary : getuid();
}

TEST(RemoveFolderDeathTest, OpensWhatWasClosed) {
  EXPECT_EXIT(make_and_remove(make_closed_folders, getuid()), testing::ExitedWithCode(0), "");
  EXPECT_EXIT(make_and_remove(make_closed_folders, ordinary_user()), testing::ExitedWithCode(0),
              "");
}

TEST(RemoveFolderDeathTest, EndsInADeepOne) {
  EXPECT_EXIT(make_and_remove(make_deep_folder, getuid()), testing::ExitedWithCode(0), "");
  EXPECT_EXIT(make_and_remove(make_deep_folder, ordinary_user()), testing::ExitedWithCode(0), "");
}

TEST(RemoveFolder, FollowsNoLink) {
  const TemporaryFolder folder;
  const fs::path kept = folder.path() / "kept", gone = folder.path() / "gone";
  write_file(kept / "file", "x");
  write_file(gone / "a" / "b" / "file", "x");
  fs::permissions(kept, fs::perms(0750));
  fs::create_symlink(kept, gone / "a" / "link");
  fs::create_hard_link(kept / "file", gone / "a" / "other");
  fs::create_symlink(kept, folder.path() / "link");
  EXPECT_EQ(remove_folder(gone), std::error_code());
  EXPECT_EQ(remove_folder(folder.path() / "link"), std::error_code());
  EXPECT_EQ(remove_folder(folder.path() / "never"), std::error_code());
  EXPECT_FALSE(fs::exists(gone));
  EXPECT_FALSE(fs::exists(fs::symlink_status(folder.path() / "link")));
  EXPECT_EQ(read_file(kept / "file").value(), "x");
  EXPECT_EQ(fs::status(kept).permissions(), fs::perms(0750));
}

}  // namespace
}  // namespace mjcourse
