#include "base/lock_wait.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <unistd.h>

#include <memory>
#include <system_error>
#include <vector>

#include "base/descriptor.h"
#include "base/files.h"
#include "base/temporary_folder.h"

namespace mjcourse {
namespace {

class LockWaitTest : public testing::Test {
 protected:
  LockWaitTest() { write_file(path_, ""); }
  Descriptor opened() const { return Descriptor(open(path_.c_str(), O_RDONLY | O_CLOEXEC)); }

  TemporaryFolder folder_;
  std::filesystem::path path_ = folder_.path() / "lo\x1b[31mck";
};

TEST_F(LockWaitTest, SaysWhomItWaitsFor) {
  Descriptor other = opened();
  ASSERT_EQ(flock(other.get(), LOCK_EX), 0);
  const Descriptor file = opened();
  const std::string holder = lock_holder(file.get());
  std::vector<std::string> told;
  // It is let go by the word itself, so no clock is asked.
  const LockWait wait{.quiet = std::chrono::milliseconds(0), .tell = [&](const std::string& text) {
                        told.push_back(text);
                        other.reset();
                      }};
  EXPECT_TRUE(take_lock(file.get(), LOCK_EX, path_, wait));
  EXPECT_EQ(told, std::vector<std::string>{"waiting for " + folder_.path().string() +
                                           "/lo\\x1b[31mck, which " + holder + " holds"});
}

TEST_F(LockWaitTest, Ends) {
  const Descriptor other = opened(), file = opened();
  EXPECT_TRUE(take_lock(other.get(), LOCK_SH, path_, LockWait::none()));
  EXPECT_TRUE(take_lock(file.get(), LOCK_SH, path_, LockWait::none()));
  EXPECT_FALSE(take_lock(file.get(), LOCK_EX, path_, LockWait::none()));
  EXPECT_FALSE(take_lock(file.get(), LOCK_EX, path_, {.most = std::chrono::milliseconds(50)}));
  EXPECT_THROW(take_lock(-1, LOCK_EX, path_, LockWait::none()), std::system_error);
}

// Some file systems and containers have other numbers for it there.
TEST_F(LockWaitTest, KnowsTheHolderWhereTheKernelSaysIt) {
  const Descriptor other = opened();
  EXPECT_EQ(lock_holder(other.get()), "another process");
  ASSERT_EQ(flock(other.get(), LOCK_EX), 0);
  const std::string holder = lock_holder(opened().get());
  if (holder == "another process") GTEST_SKIP() << "the kernel does not say it here";
  EXPECT_EQ(holder, "process " + std::to_string(getpid()) + " (base_tests)");
}

}  // namespace
}  // namespace mjcourse
