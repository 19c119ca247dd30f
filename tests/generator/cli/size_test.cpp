#include "cli/size.h"

#include <gtest/gtest.h>

namespace mjcourse {
namespace {

TEST(Size, IsReadAsPeopleWriteIt) {
  EXPECT_EQ(read_size("0"), 0U);
  EXPECT_EQ(read_size("17"), 17U);
  EXPECT_EQ(read_size("1.5kB"), 1500U);
  EXPECT_EQ(read_size("500MB"), 500'000'000U);
  EXPECT_EQ(read_size("2GB"), 2'000'000'000U);
  for (const char* wrong : {"", "GB", "-1GB", "2 GB", "2gb", "1e3", "nan", "inf", "9999999999TB"}) {
    EXPECT_EQ(read_size(wrong), std::nullopt) << wrong;
  }
}

TEST(Size, IsShownInItsUnit) {
  EXPECT_EQ(size_text(0), "0 bytes");
  EXPECT_EQ(size_text(1), "1 byte");
  EXPECT_EQ(size_text(999), "999 bytes");
  EXPECT_EQ(size_text(1234), "1.23 kB");
  EXPECT_EQ(size_text(2'000'000'000), "2 GB");
}

}  // namespace
}  // namespace mjcourse
