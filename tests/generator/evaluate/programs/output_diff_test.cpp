#include "evaluate/programs/output_diff.h"

#include <gtest/gtest.h>

namespace mjcourse {
namespace {

bool agree(std::string_view stated, std::string_view real,
           std::optional<double> tolerance = std::nullopt) {
  Retrials retrials;
  return lines_agree(stated, real, tolerance, retrials);
}

TEST(Lines, AgreeWithinAUnitOfTheLastStatedPlace) {
  EXPECT_TRUE(agree("x = 0.25", "x = 0.26"));
  EXPECT_TRUE(agree("x = 0.25", "x = 0.24"));
  EXPECT_FALSE(agree("x = 0.25", "x = 0.27"));
  EXPECT_TRUE(agree("0.1", "0.2"));  // doubles are a hair more than that apart
  EXPECT_FALSE(agree("0.1", "0.21"));
  EXPECT_TRUE(agree("-0.000", "0.001"));
  EXPECT_TRUE(agree("0.25", "0.2549999"));
  EXPECT_TRUE(agree("123456789.25", "123456789.26"));
  EXPECT_FALSE(agree("0.5499", "0.6"));  // the program has not printed what the lesson states
  EXPECT_TRUE(agree("0.999999", "1"));
}

TEST(Lines, CompareDigitsThatNoDoubleHolds) {
  EXPECT_FALSE(agree("0.30000000000000000", "0.30000000000000004"));
  EXPECT_TRUE(agree("0.30000000000000003", "0.30000000000000004"));
  EXPECT_FALSE(agree("9007199254740993", "9007199254740992"));
  EXPECT_FALSE(agree("9007199254740993.5", "9007199254740993.7"));
  EXPECT_TRUE(agree("9007199254740993.5", "9007199254740993.6"));
  EXPECT_FALSE(agree("1.0e-999", "1.2e-999"));
  EXPECT_FALSE(agree("1.0e+999", "1.2e+999"));
}

TEST(Lines, CountExactly) {
  EXPECT_TRUE(agree("nq = 30", "nq = 30"));
  EXPECT_FALSE(agree("nq = 30", "nq = 31"));
  EXPECT_FALSE(agree("30", "30.1"));
  EXPECT_TRUE(agree("30", "30.0"));
  EXPECT_FALSE(agree("2.", "3."));
  EXPECT_TRUE(agree("2.", "2."));
  EXPECT_TRUE(agree("-0", "0"));
  EXPECT_FALSE(agree("-1", "1"));
  EXPECT_FALSE(agree("007", "7"));
  EXPECT_FALSE(agree("1,234", "1,235"));
}

TEST(Lines, KnowTheLastPlaceOfAnExponent) {
  EXPECT_TRUE(agree("3e-7", "4e-7"));
  EXPECT_FALSE(agree("3e-7", "5e-7"));
  EXPECT_TRUE(agree("1.25e+03", "1.26e+03"));
  EXPECT_FALSE(agree("1.25e+03", "1.27e+03"));
  EXPECT_TRUE(agree("1.25E3", "1251"));
  EXPECT_FALSE(agree("1e", "2e"));  // no exponent: a count and a letter
  EXPECT_TRUE(agree("1.e-05", "2.e-05"));
  EXPECT_TRUE(agree("1e300", "1.0e+300"));
  EXPECT_FALSE(agree("1234e56", "1235e56"));  // as hashes may be
  EXPECT_FALSE(agree("0e12", "0e34"));
}

TEST(Lines, MayHaveAToleranceOfTheirOwn) {
  EXPECT_TRUE(agree("0.25", "0.75", 0.5));
  EXPECT_FALSE(agree("0.25", "0.76", 0.5));
  EXPECT_TRUE(agree("30", "31", 1.0));
  EXPECT_FALSE(agree("0.25", "0.26", 0.0));
  EXPECT_TRUE(agree("1.1", "1.2", 0.1));  // not a hair more, as doubles have it
  EXPECT_FALSE(agree("1.1", "1.2000000000000001", 0.1));
  EXPECT_FALSE(agree("2.2.2", "2.2.3", 1.0));
}

TEST(Lines, TakeDigitsInWordsForLetters) {
  EXPECT_TRUE(agree("l1_2 x2y", "l1_2 x2y"));
  EXPECT_FALSE(agree("box_1.5", "box_1.6"));
  EXPECT_FALSE(agree("q2", "q3"));
  EXPECT_TRUE(agree("0.5m", "0.6m"));
  EXPECT_FALSE(agree("0.5m", "0.5s"));
}

TEST(Lines, TakeWhatIsNoNumberByItselfForText) {
  const auto text = [](std::string_view one, std::string_view other) {
    EXPECT_TRUE(agree(one, one));
    EXPECT_FALSE(agree(one, other)) << one << " " << other;
    EXPECT_FALSE(agree(one, other, 100.0)) << one << " " << other;
  };
  text("MuJoCo 2.2.2", "MuJoCo 2.3.2");
  text("OpenGL version 4.5", "OpenGL version 4.6");
  text("GLSL VERSION:  1.50", "GLSL VERSION:  1.51");
  text("12.2.0-3", "12.2.1-3");
  text("gcc 12.2-14", "gcc 12.3-14");
  text("1.5~rc1 1.19+dfsg", "1.6~rc1 1.19+dfsg");
  text("gcc-12.2 numpy@1.5 lib/1.5", "gcc-12.3 numpy@1.5 lib/1.5");
  text("192.168.0.1", "192.169.0.1");
  text("0x1e5", "0x2e5");
  text("0x1.8p+1", "0x1.9p+1");
  text("7e3f 1e5a7", "7e3f 2e5a7");
  text("1234567e-1234-41d4-a716-446655440000", "1234568e-1234-41d4-a716-446655440000");
  text("0.5m-3 12ab-34", "0.5m-4 12ab-34");
  text("0f31d-a716-123e-44665544", "0f31d-a716-124e-44665544");
  text("2024-05-01", "2024-05-02");
  text("01.05.2024", "02.05.2024");
  text("12:30:05.25", "12:30:05.26");
  text("2.2rc1", "2.3rc1");
  text("nan inf", "nan -inf");
  EXPECT_TRUE(agree("conversion 0.25", "conversion 0.26"));
  EXPECT_TRUE(agree("x=0.5, y:0.25 (0.5-0.25i) 0.1-0.2s", "x=0.6, y:0.24 (0.5-0.26i) 0.2-0.2s"));
}

TEST(Lines, KnowAMinusAsBooksHaveIt) {
  EXPECT_TRUE(agree("\u22120.25", "-0.26"));
  EXPECT_FALSE(agree("\u22120.25", "0.25"));
  EXPECT_TRUE(agree("\u22120.00", "0.01"));
  EXPECT_FALSE(agree("1\u22120.1", "1-0.1"));
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
  EXPECT_TRUE(agree("id 12[..]", "id 1234"));
  EXPECT_TRUE(agree("0.12[..]", "0.1299"));
  EXPECT_TRUE(agree("[..]7.0", "17.0"));
  EXPECT_FALSE(agree("[..]7.0", "17.1"));  // the end of a number is none
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
  Retrials retrials;
  for (const DiffLine& change : output_changes(stated, real, std::nullopt, retrials)) {
    const bool in_lesson = change.kind == DiffLine::Kind::gone;
    text += (in_lesson ? "-" : "+") + std::to_string(change.line) + " " + change.text + "\n";
  }
  return text;
}

TEST(Lines, AreComparedInOneGo) {
  const std::size_t many = 1'000'000;
  const std::string spaces = "x" + std::string(many, ' ') + "y", digits(many, '3');
  EXPECT_FALSE(agree("[..] x", spaces));
  EXPECT_FALSE(agree("0." + digits + "3", "0." + digits + "5"));
  EXPECT_TRUE(agree("[..]" + digits, spaces + digits));
}

TEST(Lines, AreNotGoneThroughAgainAndAgain) {
  const auto left_by = [](const std::string& stated, const std::string& real) {
    Retrials retrials;
    EXPECT_FALSE(lines_agree(stated, real, std::nullopt, retrials));
    return retrials.left;
  };
  const std::size_t many = 100'000, all = Retrials().left;
  const std::string letters(many, 'a');
  EXPECT_EQ(left_by("[..]" + letters + "b", letters + letters), 0u);
  EXPECT_EQ(left_by("[..]" + letters + "b", "c" + letters), 0u);
  EXPECT_GT(left_by("[..] aab", letters), all / 2);
  EXPECT_EQ(left_by(letters + "b", letters + letters), all);
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
