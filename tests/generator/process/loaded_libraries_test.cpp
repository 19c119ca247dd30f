#include "process/loaded_libraries.h"

#include <gtest/gtest.h>

namespace mjcourse {
namespace {

// That others give another hash, tests/store/dependencies.mjs sees.
TEST(LoadedLibraries, AreAHash) {
  EXPECT_EQ(loaded_libraries().size(), 64);
}

}  // namespace
}  // namespace mjcourse
