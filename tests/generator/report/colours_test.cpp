#include "report/colours.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>

#include "report/pseudo_terminal.h"

namespace mjcourse {
namespace {

TEST(Colours, AreForTerminalsThatDoNotRefuseThem) {
  if (!PseudoTerminal::exists()) GTEST_SKIP();
  unsetenv("NO_COLOR");
  setenv("TERM", "xterm", 1);
  const PseudoTerminal pseudo_terminal(80);
  const int terminal = pseudo_terminal.descriptor();
  EXPECT_TRUE(wants_colours(terminal));
  setenv("NO_COLOR", "", 1);
  EXPECT_TRUE(wants_colours(terminal));
  setenv("NO_COLOR", "1", 1);
  EXPECT_FALSE(wants_colours(terminal));
  unsetenv("NO_COLOR");
  setenv("TERM", "dumb", 1);
  EXPECT_FALSE(wants_colours(terminal));
  unsetenv("TERM");
  EXPECT_TRUE(wants_colours(terminal));
}

TEST(Colours, AreNotForPipes) {
  unsetenv("NO_COLOR");
  setenv("TERM", "xterm", 1);
  int pipe_ends[2];
  ASSERT_EQ(pipe(pipe_ends), 0);
  EXPECT_FALSE(wants_colours(pipe_ends[1]));
  close(pipe_ends[0]);
  close(pipe_ends[1]);
}

}  // namespace
}  // namespace mjcourse
