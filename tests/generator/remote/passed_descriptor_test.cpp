#include "remote/passed_descriptor.h"

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <string>
#include <utility>

namespace mjcourse {
namespace {

TEST(PassedDescriptor, ComesWithItsBytes) {
  int ends[2], pipes[2];
  ASSERT_EQ(socketpair(AF_UNIX, SOCK_STREAM, 0, ends), 0);
  ASSERT_EQ(pipe(pipes), 0);
  const Descriptor from(ends[0]), to(ends[1]), read_end(pipes[0]);
  {
    const Descriptor write_end(pipes[1]);
    EXPECT_EQ(send_with(from.get(), "plain", Descriptor()), 5);
    EXPECT_EQ(send_with(from.get(), "with one", write_end), 8);
  }
  std::array<char, 64> bytes{};
  std::string all;
  Descriptor passed;
  while (all.size() < 13) {
    Received received = receive_with(to.get(), bytes.data(), 5);
    ASSERT_GT(received.count, 0);
    all.append(bytes.data(), static_cast<std::size_t>(received.count));
    if (received.passed.is_open()) passed = std::move(received.passed);
    EXPECT_EQ(passed.is_open(), all.size() > 5) << all;
  }
  EXPECT_EQ(all, "plainwith one");
  EXPECT_EQ(write(passed.get(), "x", 1), 1);
  EXPECT_EQ(read(read_end.get(), bytes.data(), bytes.size()), 1);
}

}  // namespace
}  // namespace mjcourse
