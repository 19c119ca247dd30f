#include "process/process_memory.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <unistd.h>

#include <array>
#include <bit>
#include <cerrno>
#include <climits>
#include <filesystem>
#include <latch>
#include <thread>

#include "base/descriptor.h"
#include "base/temporary_folder.h"

namespace mjcourse {
namespace {

std::uint64_t address_of(const void* place) {
  return std::bit_cast<std::uint64_t>(place);
}

// Some pages, behind which there is no memory.
class Pages {
 public:
  explicit Pages(std::size_t count)
      : size_(count * kPage),
        begin_(static_cast<char*>(mmap(nullptr, size_ + kPage, PROT_READ | PROT_WRITE,
                                       MAP_PRIVATE | MAP_ANONYMOUS, -1, 0))) {
    mprotect(begin_ + size_, kPage, PROT_NONE);
  }
  ~Pages() { munmap(begin_, size_ + kPage); }
  Pages(const Pages&) = delete;
  Pages& operator=(const Pages&) = delete;

  // Where `text` stands that ends just before there is no memory, or not at all.
  std::uint64_t end_with(const std::string& text, bool ends) const {
    char* const at = begin_ + size_ - text.size() - (ends ? 1 : 0);
    text.copy(at, text.size());
    if (ends) begin_[size_ - 1] = '\0';
    return address_of(at);
  }
  std::uint64_t beyond() const { return address_of(begin_ + size_); }

 private:
  static constexpr std::size_t kPage = 4096;
  std::size_t size_;
  char* begin_;
};

TEST(ProcessMemory, HasATextOfSeveralPages) {
  const Pages pages(2);
  const std::string text(4096 - 10, 'x');
  EXPECT_EQ(read_text(getpid(), pages.end_with(text, true)), text);
  EXPECT_EQ(read_text(getpid(), pages.end_with("", true)), "");
  const std::string across(4000, 'y');
  const std::string both = across + across;
  EXPECT_EQ(read_text(getpid(), pages.end_with(both, true)), both);
}

TEST(ProcessMemory, HasNoTextThatDoesNotEnd) {
  const Pages pages(3);
  EXPECT_EQ(read_text(getpid(), pages.end_with("abc", false)).error(), EFAULT);
  const std::string longest(PATH_MAX * 2, 'x');
  EXPECT_EQ(read_text(getpid(), pages.end_with(longest, true)).error(), EFAULT);
  EXPECT_EQ(read_text(getpid(), pages.beyond()).error(), EFAULT);
  EXPECT_EQ(read_text(getpid(), 0).error(), EFAULT);
}

TEST(ProcessMemory, HasNumbersAsAWholeOrNotAtAll) {
  const std::uint64_t number = 0x0123456789ABCDEF;
  EXPECT_EQ(read_number(getpid(), address_of(&number)), number);
  const Pages pages(1);
  EXPECT_EQ(read_number(getpid(), pages.end_with("1234", false)), std::nullopt);
  std::array<char, 4> bytes{};
  EXPECT_TRUE(read_memory(getpid(), pages.end_with("abcd", false), bytes));
  EXPECT_EQ(std::string(bytes.data(), 4), "abcd");
  EXPECT_FALSE(read_memory(getpid(), pages.end_with("abc", false), bytes));
}

TEST(ProcessMemory, ReckonsPathsAsTheProcessDoes) {
  const TemporaryFolder folder;
  const std::string path = std::filesystem::canonical(folder.path());
  const Descriptor opened(open(path.c_str(), O_PATH | O_CLOEXEC));
  const std::string here = std::filesystem::current_path();
  EXPECT_EQ(absolute_path(getpid(), AT_FDCWD, "/a/../b"), "/a/../b");
  EXPECT_EQ(absolute_path(getpid(), AT_FDCWD, "a/b"), here + "/a/b");
  EXPECT_EQ(absolute_path(getpid(), opened.get(), "a"), path + "/a");
  EXPECT_EQ(absolute_path(getpid(), opened.get(), ""), path);
  EXPECT_EQ(absolute_path(getpid(), 1'000'000, "a"), std::nullopt);
}

TEST(ProcessMemory, CountsThreads) {
  std::latch begun(2), over(1);
  pid_t id = 0;
  const int before = count_threads(getpid());
  {
    const std::jthread thread([&] {
      id = gettid();
      begun.count_down();
      over.wait();
    });
    begun.arrive_and_wait();
    EXPECT_EQ(count_threads(getpid()), before + 1);
    EXPECT_TRUE(shares_process(id, getpid()));
    EXPECT_TRUE(shares_process(getpid(), id));
    EXPECT_FALSE(shares_process(getppid(), getpid()));
    over.count_down();
  }
  EXPECT_EQ(count_threads(INT_MAX), 0);
}

}  // namespace
}  // namespace mjcourse
