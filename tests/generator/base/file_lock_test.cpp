#include "base/file_lock.h"

#include <gtest/gtest.h>

#include <atomic>
#include <optional>
#include <system_error>
#include <thread>

#include "base/temporary_folder.h"

namespace mjcourse {
namespace {

using namespace std::chrono_literals;

TEST(FileLock, HasOneHolderAtATime) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "lock";
  {
    const FileLock first(file);
    EXPECT_TRUE(first.held());
    EXPECT_FALSE(FileLock(file, LockWait::none()).held());
    EXPECT_TRUE(FileLock(folder.path() / "other", LockWait::none()).held());
  }
  EXPECT_TRUE(FileLock(file, LockWait::none()).held());
  EXPECT_TRUE(std::filesystem::exists(file));
}

TEST(FileLock, IsWaitedFor) {
  const TemporaryFolder folder;
  std::optional<FileLock> first(folder.path() / "lock");
  std::atomic<bool> got = false;
  const std::jthread other([&] {
    const FileLock second(folder.path() / "lock");
    got = second.held();
  });
  std::this_thread::sleep_for(30ms);
  EXPECT_FALSE(got);
  first.reset();
  for (int i = 0; i < 1000 && !got; ++i) std::this_thread::sleep_for(10ms);
  EXPECT_TRUE(got);
}

TEST(FileLock, IsNoLink) {
  const TemporaryFolder folder;
  std::filesystem::create_symlink("elsewhere", folder.path() / "lock");
  EXPECT_THROW(FileLock(folder.path() / "lock"), std::system_error);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "elsewhere"));
}

TEST(FileLock, SaysWhereItCannotBe) {
  try {
    const FileLock lock("/nowhere/lock");
    FAIL();
  } catch (const std::system_error& error) {
    EXPECT_STREQ(error.what(), "/nowhere/lock: No such file or directory");
  }
}

}  // namespace
}  // namespace mjcourse
