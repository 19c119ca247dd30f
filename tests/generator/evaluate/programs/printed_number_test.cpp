#include "evaluate/programs/printed_number.h"

#include <gtest/gtest.h>

#include <string>

namespace mjcourse {
namespace {

// The numbers of `line`, as they are found from left to right: "0.25|-3e-7|".
std::string numbers_in(const std::string& line) {
  std::string all;
  for (std::size_t at = 0; at < line.size();) {
    const auto number = PrintedNumber::find(line, at);
    if (number) all += line.substr(at, number->length()) + "|";
    at += number ? number->length() : 1;
  }
  return all;
}

bool numbers_agree(const std::string& stated, const std::string& real,
                   const std::optional<Decimal>& tolerance = std::nullopt) {
  return PrintedNumber::find(stated, 0).value().agrees_with(PrintedNumber::find(real, 0).value(),
                                                            tolerance);
}

TEST(PrintedNumber, IsFoundInTheFormsThatProgramsPrint) {
  EXPECT_EQ(numbers_in("x = 0.25, y=-3e-7 .5 7. +1E+03"), "0.25|-3e-7|.5|7|+1E+03|");
  EXPECT_EQ(numbers_in("1.e-05 (2) [3,4] 5%"), "1.e-05|2|3|4|5|");
  EXPECT_EQ(numbers_in("\u22120.5"), "\u22120.5|");
}

TEST(PrintedNumber, MayHaveItsUnitBehindIt) {
  EXPECT_EQ(numbers_in("0.5m 9.81m/s^2 3ms"), "0.5|9.81|2|3|");
}

TEST(PrintedNumber, EndsWhereASentenceDoes) {
  EXPECT_EQ(numbers_in("It is 1.5. And 2."), "1.5|2|");
}

TEST(PrintedNumber, IsNoPartOfAName) {
  EXPECT_EQ(numbers_in("l1_2 x1 abc-1.5 lib/1.5 a@1 c~1"), "");
}

TEST(PrintedNumber, IsNoPartOfAVersionADateATimeOrAnAddress) {
  EXPECT_EQ(numbers_in("2.2.2 12:30 12:30.5 2022-10-05 0x1e5 1.0+git 1.2~rc 7f3a"), "");
  EXPECT_EQ(numbers_in("OpenGL version: 4.5"), "");
  EXPECT_EQ(numbers_in("Version = 4.5, conversion 4.5"), "4.5|");
}

TEST(PrintedNumber, MayEndARangeOrAComplexNumber) {
  EXPECT_EQ(numbers_in("0.1-0.2"), "0.1|0.2|");
  EXPECT_EQ(numbers_in("0.5-0.1i"), "0.5|0.1|");
  EXPECT_EQ(numbers_in("12-14"), "");
}

TEST(PrintedNumber, AgreesToOneUnitOfItsLastPlace) {
  EXPECT_TRUE(numbers_agree("0.25", "0.26"));
  EXPECT_TRUE(numbers_agree("0.25", "0.2449"));
  EXPECT_FALSE(numbers_agree("0.25", "0.2601"));
  EXPECT_TRUE(numbers_agree("1.5e-07", "1.6e-07"));
  EXPECT_FALSE(numbers_agree("1.5e-07", "1.7e-07"));
  EXPECT_TRUE(numbers_agree("-0.00", "0.01"));
}

TEST(PrintedNumber, ThatIsACountAgreesWithItselfAlone) {
  EXPECT_TRUE(numbers_agree("7", "7"));
  EXPECT_FALSE(numbers_agree("7", "8"));
  EXPECT_FALSE(numbers_agree("007", "7"));
  EXPECT_FALSE(numbers_agree("7", "-7"));
  EXPECT_TRUE(numbers_agree("0", "-0"));
  EXPECT_TRUE(numbers_agree("7", "7.0"));
  EXPECT_FALSE(numbers_agree("7", "7.1"));
}

TEST(PrintedNumber, AgreesToATolerance) {
  EXPECT_TRUE(numbers_agree("7", "8", Decimal(1)));
  EXPECT_FALSE(numbers_agree("7", "8.1", Decimal(1)));
  EXPECT_FALSE(numbers_agree("0.25", "0.26", Decimal(0.001)));
  EXPECT_TRUE(numbers_agree("0.25", "0.251", Decimal(0.001)));
}

}  // namespace
}  // namespace mjcourse
