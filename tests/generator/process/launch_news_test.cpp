#include "process/launch_news.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>

#include <array>
#include <cerrno>

namespace mjcourse {
namespace {

class LaunchNewsTest : public testing::Test {
 protected:
  LaunchNewsTest() {
    std::array<int, 2> ends{};
    EXPECT_EQ(socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends.data()), 0);
    child_ = Descriptor(ends[0]);
    ours_ = Descriptor(ends[1]);
  }

  Descriptor child_, ours_;
};

TEST_F(LaunchNewsTest, ComeOneByOneUntilTheProgramHasBegun) {
  tell_id(child_.get(), 42);
  tell_failure(child_.get(), ENOENT);
  child_ = Descriptor();
  const LaunchNews first = read_launch_news(ours_.get());
  EXPECT_EQ(first.id, 42);
  EXPECT_EQ(first.failure, 0);
  EXPECT_FALSE(first.begun);
  EXPECT_FALSE(first.listener.is_open());
  const LaunchNews second = read_launch_news(ours_.get());
  EXPECT_EQ(second.failure, ENOENT);
  EXPECT_FALSE(second.begun);
  EXPECT_TRUE(read_launch_news(ours_.get()).begun);
}

TEST_F(LaunchNewsTest, BringADescriptorOfTheSameFile) {
  const Descriptor file(open("/dev/null", O_RDONLY | O_CLOEXEC));
  tell_listener(child_.get(), file.get());
  const LaunchNews news = read_launch_news(ours_.get());
  ASSERT_TRUE(news.listener.is_open());
  EXPECT_NE(news.listener.get(), file.get());
  struct stat sent {
  }, got{};
  fstat(file.get(), &sent);
  fstat(news.listener.get(), &got);
  EXPECT_EQ(got.st_rdev, sent.st_rdev);
  EXPECT_EQ(got.st_ino, sent.st_ino);
  // No program that is started later gets it.
  EXPECT_EQ(fcntl(news.listener.get(), F_GETFD), FD_CLOEXEC);
}

// A signal for a listener that has gone would end the process that tells.
TEST_F(LaunchNewsTest, ThatNobodyReadsAreLost) {
  ours_ = Descriptor();
  tell_id(child_.get(), 42);
  tell_failure(child_.get(), ENOENT);
}

}  // namespace
}  // namespace mjcourse
