#include "course/flow_list.h"

#include <gtest/gtest.h>

namespace mjcourse {
namespace {

// `text` has `|` where the list begins and before each of its items; gives it with X as the item
// `index`.
std::string with_x(const std::string& marked, std::size_t index) {
  std::string text;
  std::vector<std::size_t> places;
  for (const char c : marked) {
    c == '|' ? places.push_back(text.size()) : text.push_back(c);
  }
  const std::vector<std::size_t> items(places.begin() + 1, places.end());
  return insert_into_flow_list(text, places.front(), items, index, "X").value_or("nothing");
}

TEST(FlowList, TakesAnItemOnItsLine) {
  EXPECT_EQ(with_x("a: |[]", 0), "a: [X]");
  EXPECT_EQ(with_x("a: |[|b, |c]", 0), "a: [X, b, c]");
  EXPECT_EQ(with_x("a: |[|b, |c]", 1), "a: [b, X, c]");
  EXPECT_EQ(with_x("a: |[|b, |c] # end", 2), "a: [b, c, X] # end");
  EXPECT_EQ(with_x("a: |[|b, ]", 1), "a: [b, X ]");
}

TEST(FlowList, TakesAnItemOnALineOfItsOwn) {
  EXPECT_EQ(with_x("a: |[\n  |b,\n  |c\n]\n", 2), "a: [\n  b,\n  c,\n  X\n]\n");
  EXPECT_EQ(with_x("a: |[\n  |b,\n  |c,\n]\n", 2), "a: [\n  b,\n  c,\n  X,\n]\n");
  EXPECT_EQ(with_x("a: |[\n  |b,\n  |c\n]\n", 1), "a: [\n  b,\n  X,\n  c\n]\n");
  EXPECT_EQ(with_x("a: |[\n  |b,\n  |c]\n", 2), "a: [\n  b,\n  c,\n  X]\n");
}

TEST(FlowList, KeepsTheCommentOfTheLastItem) {
  EXPECT_EQ(with_x("|[\n  |b # why, [not\n]\n", 1), "[\n  b, # why, [not\n  X\n]\n");
}

TEST(FlowList, KeepsHowLinesEnd) {
  EXPECT_EQ(with_x("|[\r\n  |b\r\n]\r\n", 1), "[\r\n  b,\r\n  X\r\n]\r\n");
}

TEST(FlowList, KnowsWhatIsInItsItems) {
  EXPECT_EQ(with_x("|[|{a: [1, 2]}, |\"]\", |'it''s ]']", 3), "[{a: [1, 2]}, \"]\", 'it''s ]', X]");
  EXPECT_EQ(with_x("|[|\"\\\"]\"]", 1), "[\"\\\"]\", X]");
  // A quote or a number sign inside of a word is a part of it.
  EXPECT_EQ(with_x("|[|it's, |a#b]", 2), "[it's, a#b, X]");
}

TEST(FlowList, MustBegin) {
  EXPECT_EQ(with_x("a: |b", 0), "nothing");
  EXPECT_EQ(with_x("a: |", 0), "nothing");
}

TEST(FlowList, MustEnd) {
  EXPECT_EQ(with_x("a: |[|b", 1), "nothing");
  EXPECT_EQ(with_x("a: |[|\"b]", 1), "nothing");
  EXPECT_EQ(with_x("a: |[|b # ]", 1), "nothing");
}

}  // namespace
}  // namespace mjcourse
