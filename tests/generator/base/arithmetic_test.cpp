#include "base/arithmetic.h"

#include <gtest/gtest.h>

namespace mjcourse {
namespace {

// That all round so, Example.RoundsTheSameOnAllProcessors sees.
TEST(Arithmetic, IsOfTheArchitectureAndTheSetting) {
  EXPECT_TRUE(arithmetic().ends_with(" glibc.cpu.hwcaps=-FMA,-FMA4,-AVX2")) << arithmetic();
}

// That what is drawn depends on them, tests/store/machines.mjs sees.
TEST(ProcessorFeatures, AreWords) {
  EXPECT_EQ(processor_features().find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789 "),
            std::string::npos);
}

}  // namespace
}  // namespace mjcourse
