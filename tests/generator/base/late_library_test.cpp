#include "base/late_library.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

namespace mjcourse {
namespace {

constexpr const char* kMathematics = "libm.so.6";
constexpr const char* kMissing = "libmissing.so.7";

template <typename Work>
std::string failure_of(const Work& work) {
  try {
    work();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "none";
}

TEST(LateLibrary, HasItsFunctionsByTheirTypes) {
  const LateFunction<kMathematics, double(double, double)> power("pow");
  EXPECT_EQ(power(2, 10), 1024);
  EXPECT_EQ(power(3, 2), 9);
}

TEST(LateLibrary, SaysWhatIsNotThere) {
  const LateFunction<kMissing, void()> missing("anything");
  EXPECT_EQ(failure_of(missing),
            "cannot load a library: libmissing.so.7: cannot open shared object file: "
            "No such file or directory");
  const LateFunction<kMathematics, void()> unknown("no_such_function");
  EXPECT_NE(failure_of(unknown).find("undefined symbol: no_such_function"), std::string::npos)
      << failure_of(unknown);
}

}  // namespace
}  // namespace mjcourse
