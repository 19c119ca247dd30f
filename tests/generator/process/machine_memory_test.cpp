#include "process/machine_memory.h"

#include <gtest/gtest.h>

#include "base/files.h"
#include "base/temporary_folder.h"

namespace mjcourse {
namespace {

constexpr std::uint64_t kMiB = 1 << 20;

// A machine of 16 GiB.
class MachineMemory : public testing::Test {
 protected:
  MachineMemory() {
    write("proc/meminfo", "MemTotal:       16777216 kB\nMemFree:         1000000 kB\n");
  }
  void write(const std::string& path, const std::string& text) const {
    write_file(folder_.path() / path, text);
  }
  std::uint64_t mebibytes() const { return machine_memory(folder_.path()) / kMiB; }

  TemporaryFolder folder_;
};

TEST_F(MachineMemory, IsThatOfTheMachine) {
  EXPECT_EQ(mebibytes(), 16384U);
  write("proc/self/cgroup", "0::/\n");
  write("sys/fs/cgroup/memory.max", "max\n");
  EXPECT_EQ(mebibytes(), 16384U);
  write("sys/fs/cgroup/memory.max", "99999999999999\n");
  EXPECT_EQ(mebibytes(), 16384U);
}

TEST_F(MachineMemory, IsWhatAContainerHas) {
  write("proc/self/cgroup", "0::/\n");
  write("sys/fs/cgroup/memory.max", "2147483648\n");
  EXPECT_EQ(mebibytes(), 2048U);
}

TEST_F(MachineMemory, IsTheLeastOfAllGroupsAround) {
  write("proc/self/cgroup", "0::/user.slice/a:b/c\n");
  write("sys/fs/cgroup/user.slice/a:b/c/memory.max", "max\n");
  write("sys/fs/cgroup/user.slice/a:b/memory.max", "3221225472\n");
  write("sys/fs/cgroup/user.slice/memory.max", "4294967296\n");
  EXPECT_EQ(mebibytes(), 3072U);
}

TEST_F(MachineMemory, IsWhatTheFirstVersionOfGroupsSays) {
  write("proc/self/cgroup", "5:cpu,memory:/docker/x\n3:cpuset:/docker/x\n0::/\n");
  // Seen from inside of a container, where its own group is the root.
  write("sys/fs/cgroup/memory/memory.limit_in_bytes", "1073741824\n");
  EXPECT_EQ(mebibytes(), 1024U);
  write("sys/fs/cgroup/memory/docker/x/memory.limit_in_bytes", "536870912\n");
  EXPECT_EQ(mebibytes(), 512U);
}

TEST_F(MachineMemory, IsBoundlessWhereNothingTells) {
  const TemporaryFolder empty;
  EXPECT_EQ(machine_memory(empty.path()), UINT64_MAX);
  EXPECT_LT(machine_memory(), UINT64_MAX);
}

}  // namespace
}  // namespace mjcourse
