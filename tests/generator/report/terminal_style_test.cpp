#include "report/terminal_style.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>

#include "report/pseudo_terminal.h"

namespace mjcourse {
namespace {

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
  if (!PseudoTerminal::exists()) GTEST_SKIP();
  const PseudoTerminal terminal(120);
  const TerminalStyle style = style_for(terminal.descriptor());
  EXPECT_EQ(style.width, 119);
  EXPECT_TRUE(style.wraps);
  EXPECT_TRUE(style.colours);
}

TEST_F(TerminalStyleTest, IsAsWideAsItsReaderSays) {
  if (!PseudoTerminal::exists()) GTEST_SKIP();
  const PseudoTerminal terminal(120);
  setenv("COLUMNS", "72", 1);
  EXPECT_EQ(style_for(terminal.descriptor()).width, 71);
  setenv("COLUMNS", "wide", 1);
  EXPECT_EQ(style_for(terminal.descriptor()).width, 119);
}

TEST_F(TerminalStyleTest, IsNeverTooNarrowToRead) {
  if (!PseudoTerminal::exists()) GTEST_SKIP();
  EXPECT_EQ(style_for(PseudoTerminal(12).descriptor()).width, 39);
  EXPECT_EQ(style_for(PseudoTerminal(0).descriptor()).width, 100);
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
