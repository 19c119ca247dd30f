#include "evaluate/programs/decimal.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace mjcourse {
namespace {

// "-12.5e3" with its point where it stands.
Decimal decimal(std::string text) {
  const bool negative = text.starts_with('-');
  if (negative) text.erase(0, 1);
  const std::size_t e = text.find('e');
  const int exponent = e == text.npos ? 0 : std::stoi(text.substr(e + 1));
  text = text.substr(0, e);
  const std::size_t point = std::min(text.find('.'), text.size());
  std::string digits = text;
  std::erase(digits, '.');
  return {negative, digits, static_cast<int>(point), exponent};
}

bool within(const std::string& a, const std::string& b, const std::string& most) {
  const bool one = Decimal::within(decimal(a), decimal(b), decimal(most));
  EXPECT_EQ(Decimal::within(decimal(b), decimal(a), decimal(most)), one) << a << " " << b;
  return one;
}

TEST(Decimal, KnowsWhatNoDoubleHolds) {
  EXPECT_TRUE(within("0.3", "0.2", "0.1"));
  EXPECT_FALSE(within("0.3", "0.2", "0.0999999999999999999"));
  EXPECT_TRUE(within("9007199254740993", "9007199254740992", "1"));
  EXPECT_FALSE(within("9007199254740993", "9007199254740992", "0"));
}

TEST(Decimal, BorrowsFromAnyPlace) {
  EXPECT_TRUE(within("1000", "999.9", "0.1"));
  EXPECT_FALSE(within("1000", "999.8", "0.1"));
  EXPECT_TRUE(within("-0.05", "0.05", "0.1"));
  EXPECT_FALSE(within("-0.05", "0.06", "0.1"));
  EXPECT_TRUE(within("0.1", "-0.1", "0.2"));
}

TEST(Decimal, IsTheSameHoweverItIsWritten) {
  EXPECT_TRUE(within("1.25e2", "125.000", "0"));
  EXPECT_TRUE(within("00125", "125", "0"));
  EXPECT_TRUE(within("-0", "0e9", "0"));
  EXPECT_FALSE(within("1e-300", "0", "1e-301"));
  EXPECT_TRUE(within("1e-300", "0", "1e-300"));
}

TEST(Decimal, IsTheShortestThatReadsAsADouble) {
  const auto same = [](double value, const std::string& text) {
    return Decimal::within(Decimal(value), decimal(text), decimal("0"));
  };
  EXPECT_TRUE(same(0.1, "0.1"));
  EXPECT_TRUE(same(-123.456, "-123.456"));
  EXPECT_TRUE(same(5e-324, "5e-324"));
  EXPECT_TRUE(same(1e300, "1e300"));
  EXPECT_TRUE(same(0, "0"));
  EXPECT_FALSE(same(0.1 + 0.2, "0.3"));
}

TEST(Decimal, HasAUnitOfItsLastPlace) {
  const auto unit = [](const std::string& text, const std::string& expected) {
    return Decimal::within(Decimal::unit_of(decimal(text)), decimal(expected), decimal("0"));
  };
  EXPECT_TRUE(unit("1.25", "0.01"));
  EXPECT_TRUE(unit("-1.250", "0.001"));
  EXPECT_TRUE(unit("125", "1"));
  EXPECT_TRUE(unit("1.5e-3", "0.0001"));
  EXPECT_TRUE(unit("1.5e3", "100"));
}

}  // namespace
}  // namespace mjcourse
