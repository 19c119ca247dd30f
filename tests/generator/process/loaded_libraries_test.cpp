#include "process/loaded_libraries.h"

#include <gtest/gtest.h>

#include "base/arithmetic.h"

namespace mjcourse {
namespace {

// That others give another hash, tests/store/dependencies.mjs sees.
TEST(LoadedLibraries, AreAHash) {
  EXPECT_EQ(loaded_libraries().size(), 64);
}

TEST(Arithmetic, EndsInAHash) {
  const std::string& found = arithmetic();
  ASSERT_GE(found.size(), 16);
  EXPECT_EQ(found.substr(found.size() - 16).find_first_not_of("0123456789abcdef"), found.npos);
}

}  // namespace
}  // namespace mjcourse
