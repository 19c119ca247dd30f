#include "process/group_use.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <unistd.h>

#include <string>
#include <vector>

#include "base/descriptor.h"
#include "base/files.h"
#include "base/temporary_folder.h"

namespace mjcourse {
namespace {

constexpr std::uint64_t kMebibyte = 1 << 20;

class GroupUseTest : public testing::Test {
 protected:
  GroupUseTest() { sandbox_.write = {folder_.path().string()}; }

  // A file of a mebibyte.
  Descriptor make(const std::string& name) const {
    write_file(folder_.path() / name, std::string(kMebibyte, 'x'));
    return Descriptor(open((folder_.path() / name).c_str(), O_RDWR | O_CLOEXEC));
  }
  void remove(const std::string& name) const { std::filesystem::remove(folder_.path() / name); }
  std::uint64_t removed() const { return use_of_group(getpid(), sandbox_).removed; }

  TemporaryFolder folder_;
  Sandbox sandbox_;
};

TEST_F(GroupUseTest, CountsMemoryThatIsResident) {
  const std::uint64_t before = use_of_group(getpid(), sandbox_).memory;
  const std::vector<char> block(64 * kMebibyte, 'x');
  const std::uint64_t now = use_of_group(getpid(), sandbox_).memory;
  EXPECT_GE(now, before + 60 * kMebibyte);
  EXPECT_LT(now, before + 100 * kMebibyte);
}

TEST_F(GroupUseTest, CountsAFileOnceItIsRemovedAndOnlyOnce) {
  const Descriptor file = make("a");
  EXPECT_EQ(removed(), 0U);
  remove("a");
  EXPECT_EQ(removed(), kMebibyte);
  const Descriptor again(dup(file.get()));
  EXPECT_EQ(removed(), kMebibyte);
}

TEST_F(GroupUseTest, CountsNoFileThatAnotherNameHas) {
  const Descriptor file = make("a");
  std::filesystem::create_hard_link(folder_.path() / "a", folder_.path() / "b");
  remove("a");
  EXPECT_EQ(removed(), 0U);
}

// Root may look through a mapping; to others it is as large as a file may be.
TEST_F(GroupUseTest, CountsAFileThatIsOnlyMapped) {
  sandbox_.file_bytes = kMebibyte;
  void* mapped = MAP_FAILED;
  {
    const Descriptor file = make("a");
    mapped = mmap(nullptr, kMebibyte, PROT_READ, MAP_SHARED, file.get(), 0);
  }
  ASSERT_NE(mapped, MAP_FAILED);
  EXPECT_EQ(removed(), 0U);
  remove("a");
  EXPECT_EQ(removed(), kMebibyte);
  sandbox_.write = {"/elsewhere"};
  EXPECT_EQ(removed(), 0U);
  munmap(mapped, kMebibyte);
}

TEST_F(GroupUseTest, OfOneThatStartsOthersIsTheSumOfItsGroup) {
  sandbox_.processes = true;
  const GroupUse group = use_of_group(getpgrp(), sandbox_);
  EXPECT_GE(group.memory, use_of_group(getpid(), Sandbox()).memory / 2);
  EXPECT_EQ(use_of_group(1 << 30, sandbox_).memory, 0U);
}

}  // namespace
}  // namespace mjcourse
