#include "report/terminal_style.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdlib>

namespace mjcourse {
namespace {

// A terminal of `columns`, which nobody looks at.
class Terminal {
 public:
  explicit Terminal(unsigned short columns)
      : main_(posix_openpt(O_RDWR | O_NOCTTY)), descriptor_(main_) {
    grantpt(main_);
    unlockpt(main_);
    descriptor_ = open(ptsname(main_), O_RDWR | O_NOCTTY);
    const winsize size{24, columns, 0, 0};
    ioctl(descriptor_, TIOCSWINSZ, &size);
  }
  ~Terminal() {
    close(descriptor_);
    close(main_);
  }
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  int descriptor() const { return descriptor_; }

 private:
  int main_, descriptor_;
};

class TerminalStyleTest : public testing::Test {
 protected:
  void SetUp() override {
    unsetenv("COLUMNS");
    unsetenv("NO_COLOR");
    setenv("TERM", "xterm", 1);
  }
  void TearDown() override { unsetenv("COLUMNS"); }
};

TEST_F(TerminalStyleTest, IsAsWideAsTheTerminal) {
  const Terminal terminal(120);
  const TerminalStyle style = style_for(terminal.descriptor());
  EXPECT_EQ(style.width, 119);
  EXPECT_TRUE(style.wraps);
  EXPECT_TRUE(style.colours);
}

TEST_F(TerminalStyleTest, IsAsWideAsItsReaderSays) {
  const Terminal terminal(120);
  setenv("COLUMNS", "72", 1);
  EXPECT_EQ(style_for(terminal.descriptor()).width, 71);
  setenv("COLUMNS", "wide", 1);
  EXPECT_EQ(style_for(terminal.descriptor()).width, 119);
}

TEST_F(TerminalStyleTest, IsNeverTooNarrowToRead) {
  EXPECT_EQ(style_for(Terminal(12).descriptor()).width, 39);
  EXPECT_EQ(style_for(Terminal(0).descriptor()).width, 100);
}

TEST_F(TerminalStyleTest, LeavesAPipeItsLongLines) {
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  setenv("COLUMNS", "40", 1);
  const TerminalStyle style = style_for(ends[1]);
  EXPECT_EQ(style.width, 100);
  EXPECT_FALSE(style.wraps);
  EXPECT_FALSE(style.colours);
  close(ends[0]);
  close(ends[1]);
}

}  // namespace
}  // namespace mjcourse
