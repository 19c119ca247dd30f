#include "evaluate/output_diff.h"

#include <gtest/gtest.h>

namespace mjcourse {
namespace {

bool agree(std::string_view stated, std::string_view real,
           std::optional<double> tolerance = std::nullopt) {
  return lines_agree(stated, real, tolerance);
}

TEST(Lines, AgreeWithinAUnitOfTheLastStatedPlace) {
  EXPECT_TRUE(agree("x = 0.25", "x = 0.26"));
  EXPECT_TRUE(agree("x = 0.25", "x = 0.24"));
  EXPECT_FALSE(agree("x = 0.25", "x = 0.27"));
  EXPECT_TRUE(agree("0.1", "0.2"));  // a unit, and the hair that binary adds
  EXPECT_FALSE(agree("0.1", "0.21"));
  EXPECT_TRUE(agree("-0.000", "0.001"));
  EXPECT_TRUE(agree("0.25", "0.2549999"));
  EXPECT_TRUE(agree("123456789.25", "123456789.26"));
}

TEST(Lines, CountExactly) {
  EXPECT_TRUE(agree("nq = 30", "nq = 30"));
  EXPECT_FALSE(agree("nq = 30", "nq = 31"));
  EXPECT_FALSE(agree("30", "30.1"));
  EXPECT_TRUE(agree("30", "30.0"));
  EXPECT_FALSE(agree("2.", "3."));
  EXPECT_TRUE(agree("2.", "2."));
}

TEST(Lines, KnowTheLastPlaceOfAnExponent) {
  EXPECT_TRUE(agree("3e-7", "4e-7"));
  EXPECT_FALSE(agree("3e-7", "5e-7"));
  EXPECT_TRUE(agree("1.25e+03", "1.26e+03"));
  EXPECT_FALSE(agree("1.25e+03", "1.27e+03"));
  EXPECT_TRUE(agree("1.25E3", "1251"));
  EXPECT_FALSE(agree("1e", "2e"));  // no exponent: a count and a letter
}

TEST(Lines, MayHaveAToleranceOfTheirOwn) {
  EXPECT_TRUE(agree("0.25", "0.75", 0.5));
  EXPECT_FALSE(agree("0.25", "0.76", 0.5));
  EXPECT_TRUE(agree("30", "31", 1.0));
  EXPECT_FALSE(agree("0.25", "0.26", 0.0));
}

TEST(Lines, TakeDigitsInWordsForLetters) {
  EXPECT_TRUE(agree("l1_2 x2y", "l1_2 x2y"));
  EXPECT_FALSE(agree("box_1.5", "box_1.6"));
  EXPECT_FALSE(agree("q2", "q3"));
  EXPECT_TRUE(agree("0.5m", "0.6m"));
  EXPECT_FALSE(agree("0.5m", "0.5s"));
}

TEST(Lines, AgreeWhateverTheWidthOfTheSpacesBetween) {
  EXPECT_TRUE(agree("a   1.0", "a 1.0"));
  EXPECT_TRUE(agree("a 1.0  ", "a 1.0"));
  EXPECT_FALSE(agree("a b", "ab"));
  EXPECT_FALSE(agree("1 2", "12"));
}

TEST(Lines, AgreeWhereAColumnShiftsByASignOrADigit) {
  EXPECT_TRUE(agree("x  0.000  1.0", "x -0.000  1.0"));
  EXPECT_TRUE(agree(" 0.000 1.0", "-0.000 1.0"));
  EXPECT_TRUE(agree("[ 9.9, -0.0]", "[10.0,  0.0]"));
  EXPECT_FALSE(agree("[ 9.9]", "[-9.9]"));
}

TEST(Lines, AgreeWithThemselvesWhateverTheirNumbers) {
  EXPECT_TRUE(agree("1e999 -1e999", "1e999 -1e999"));
  EXPECT_TRUE(agree("nan inf", "nan inf"));
}

TEST(Lines, TakeAGapForAnyText) {
  EXPECT_TRUE(agree("time [..] s", "time 0.123 s"));
  EXPECT_TRUE(agree("[..] s", "whatever it took s"));
  EXPECT_TRUE(agree("time [..]", "time is up"));
  EXPECT_TRUE(agree("[..]", ""));
  EXPECT_TRUE(agree("a[..]b", "ab"));
  EXPECT_FALSE(agree("time [..] s", "time 0.123 ms"));
  EXPECT_FALSE(agree("[..] 5.0", "is 7.0"));
}

TEST(Lines, TakeSeveralGaps) {
  EXPECT_TRUE(agree("[..]a[..]b[..]", "xaya zbb"));
  EXPECT_TRUE(agree("[..] 1.0 [..] 2.0", "x 3 1.1 y 2.1 z 2.0"));
  EXPECT_FALSE(agree("[..]a[..]b[..]", "only b before a"));
  EXPECT_FALSE(agree("a[..]b[..]c", "a c b"));
}

// Each change as "-2 text" or "+2 text".
std::string changes(std::string_view stated, std::string_view real) {
  std::string text;
  for (const DiffLine& change : output_changes(stated, real, std::nullopt)) {
    const bool in_lesson = change.kind == DiffLine::Kind::gone;
    text += (in_lesson ? "-" : "+") + std::to_string(change.line) + " " + change.text + "\n";
  }
  return text;
}

TEST(OutputChanges, AreNoneWhenNothingChanged) {
  EXPECT_EQ(changes("a\nb 0.5\n", "a\nb 0.6\n"), "");
  EXPECT_EQ(changes("", ""), "");
}

TEST(OutputChanges, DoNotMindWhiteSpaceAtTheEnd) {
  EXPECT_EQ(changes("a\nb\n", "a  \nb\n\n \n"), "");
  EXPECT_EQ(changes("a\r\nb", "a\nb\n"), "");
  EXPECT_EQ(changes("\na", "a"), "-1 \n");  // at the start it does count
}

TEST(OutputChanges, ShowALineThatChanged) {
  EXPECT_EQ(changes("a\nb 1\nc\n", "a\nb 2\nc\n"), "-2 b 1\n+3 b 2\n");
}

TEST(OutputChanges, ShowLinesThatAreMissingOrMore) {
  EXPECT_EQ(changes("a\nb\nc\n", "a\nc\n"), "-2 b\n");
  EXPECT_EQ(changes("a\nc\n", "a\nb\nb2\nc\n"), "+2 b\n+2 b2\n");
  EXPECT_EQ(changes("a\n", "a\nb\n"), "+2 b\n");
  EXPECT_EQ(changes("a\nb\n", ""), "-1 a\n-2 b\n");
  EXPECT_EQ(changes("", "a\n"), "+1 a\n");
}

TEST(OutputChanges, ShowALineThatMoved) {
  EXPECT_EQ(changes("a\nb\nc\n", "b\nc\na\n"), "-1 a\n+4 a\n");
}

}  // namespace
}  // namespace mjcourse
