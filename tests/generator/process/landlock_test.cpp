#include "process/landlock.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <string>

#include "process/sandbox.h"

namespace mjcourse {
namespace {

class LandlockTest : public testing::Test {
 protected:
  ~LandlockTest() override {
    if (before_.empty()) {
      unsetenv("MJCOURSE_LANDLOCK");
    } else {
      setenv("MJCOURSE_LANDLOCK", before_.c_str(), 1);
    }
  }
  static std::string variable() {
    const char* const value = std::getenv("MJCOURSE_LANDLOCK");
    return value == nullptr ? "" : value;
  }
  static int abi_with(const char* value) {
    setenv("MJCOURSE_LANDLOCK", value, 1);
    return landlock_abi();
  }
  static int abi_of_kernel() {
    unsetenv("MJCOURSE_LANDLOCK");
    return landlock_abi();
  }

 private:
  const std::string before_ = variable();
};

TEST_F(LandlockTest, IsOnlyEverLoweredByATest) {
  const int own = abi_of_kernel();
  EXPECT_EQ(abi_with("1"), std::min(own, 1));
  EXPECT_EQ(abi_with("0"), 0);
  EXPECT_EQ(abi_with("-1"), 0);
  EXPECT_EQ(abi_with("1000"), own);
}

SandboxLevel level(int landlock) {
  SandboxLevel level;
  level.filter = level.watch = true;
  level.landlock = landlock;
  level.user = SandboxLevel::User::own;
  return level;
}

TEST_F(LandlockTest, SaysWhatIsWeaker) {
  EXPECT_EQ(level(6).weakness(), "");
  EXPECT_EQ(level(7).weakness(), "");
  EXPECT_EQ(level(5).weakness(), "seccomp alone keeps signals from others");
  EXPECT_EQ(
      level(3).weakness(),
      "seccomp alone keeps programs from the network; seccomp alone keeps signals from others");
  EXPECT_EQ(level(0).weakness(), "no Landlock keeps programs from files");
  SandboxLevel unseen = level(6);
  unseen.watch = false;
  EXPECT_EQ(unseen.weakness(), "nobody sees which files a program names");
  unseen.filter = false;
  EXPECT_EQ(unseen.weakness(),
            "no seccomp keeps programs from system calls; nobody sees which files a program names");
}

}  // namespace
}  // namespace mjcourse
