#include "report/colours.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>

namespace mjcourse {
namespace {

// A terminal that nobody looks at has colours, a pipe has none.
TEST(Colours, AreForTerminalsThatDoNotRefuseThem) {
  unsetenv("NO_COLOR");
  setenv("TERM", "xterm", 1);
  const int terminal = posix_openpt(O_RDWR | O_NOCTTY);
  ASSERT_GE(terminal, 0);
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
  close(terminal);

  int pipe_ends[2];
  ASSERT_EQ(pipe(pipe_ends), 0);
  EXPECT_FALSE(wants_colours(pipe_ends[1]));
  close(pipe_ends[0]);
  close(pipe_ends[1]);
}

}  // namespace
}  // namespace mjcourse
