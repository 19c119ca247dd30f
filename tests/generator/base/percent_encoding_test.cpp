#include "base/percent_encoding.h"

#include <gtest/gtest.h>

namespace mjcourse {
namespace {

TEST(PercentEncoding, EncodesEachByteThatIsNotPlain) {
  EXPECT_EQ(percent_encoded("a b/ö\n%~", is_unreserved), "a%20b%2F%C3%B6%0A%25~");
  EXPECT_EQ(percent_encoded("a b", [](char c) { return c == ' '; }), "%61 %62");
  EXPECT_EQ(percent_encoded("", is_unreserved), "");
}

TEST(PercentEncoding, KnowsWhatStandsAnywhere) {
  EXPECT_EQ(percent_encoded("AZaz09-._~", is_unreserved), "AZaz09-._~");
  EXPECT_EQ(percent_encoded("@[`{/:\xFF", is_unreserved), "%40%5B%60%7B%2F%3A%FF");
}

TEST(PercentEncoding, ReadsOneByte) {
  EXPECT_EQ(encoded_byte("a%20b", 1), ' ');
  EXPECT_EQ(encoded_byte("%c3%B6", 0), '\xC3');
  EXPECT_EQ(encoded_byte("%c3%B6", 3), '\xB6');
  EXPECT_EQ(encoded_byte("%00", 0), '\0');
  for (const char* none : {"", "%", "%4", "%zz", "%4z", "% 4", "%-4", "%+4", "220"}) {
    EXPECT_EQ(encoded_byte(none, 0), std::nullopt) << none;
  }
}

}  // namespace
}  // namespace mjcourse
