#include "lsp/text_point.h"

#include <gtest/gtest.h>

namespace mjcourse {
namespace {

// One byte, two, three, and four, which are two units of UTF-16.
const SourceText kText("x.md", "aö…😀z\r\nnext\n");

std::size_t at(int line, int unit, Units units) {
  return offset_of(kText, {line, unit}, units);
}

TEST(TextPoint, CountsUnits) {
  EXPECT_EQ(count_units("aö…😀z", Units::utf16), 6);
  EXPECT_EQ(count_units("aö…😀z", Units::utf8), 11);
}

TEST(TextPoint, IsAByte) {
  EXPECT_EQ(at(0, 3, Units::utf16), 6U);
  EXPECT_EQ(at(0, 5, Units::utf16), 10U);
  EXPECT_EQ(at(0, 10, Units::utf8), 10U);
  EXPECT_EQ(at(1, 2, Units::utf16), 15U);
}

TEST(TextPoint, InsideOfACharacterIsItsBeginning) {
  EXPECT_EQ(at(0, 4, Units::utf16), 6U);
  EXPECT_EQ(at(0, 8, Units::utf8), 6U);
}

TEST(TextPoint, PastAnEndIsTheEnd) {
  EXPECT_EQ(at(0, 100, Units::utf16), 11U);
  EXPECT_EQ(at(1, 100, Units::utf8), 17U);
  EXPECT_EQ(at(2, 0, Units::utf16), 18U);
  EXPECT_EQ(at(100, 5, Units::utf16), 18U);
}

TEST(TextPoint, ComesBack) {
  for (const Units units : {Units::utf16, Units::utf8}) {
    for (const std::size_t offset : {0U, 1U, 3U, 6U, 10U, 11U, 13U, 15U, 18U}) {
      EXPECT_EQ(offset_of(kText, point_of(kText, offset, units), units), offset);
    }
  }
}

}  // namespace
}  // namespace mjcourse
