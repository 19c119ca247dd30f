#include "process/our_command.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace mjcourse {
namespace {

TEST(OurCommand, IsNamedAsItsReaderCalledIt) {
  const char* const former = std::getenv("MJCOURSE_CALLED");
  const std::string kept = former == nullptr ? "" : former;
  setenv("MJCOURSE_CALLED", "./mjcourse", 1);
  EXPECT_EQ(called_as(), "./mjcourse");
  EXPECT_EQ(our_command("accept 1.2"), "`./mjcourse accept 1.2`");
  for (const bool is_set : {false, true}) {
    is_set ? setenv("MJCOURSE_CALLED", "", 1) : unsetenv("MJCOURSE_CALLED");
    EXPECT_EQ(our_command("accept"), "`mjcourse accept`");
  }
  if (former != nullptr) setenv("MJCOURSE_CALLED", kept.c_str(), 1);
}

}  // namespace
}  // namespace mjcourse
