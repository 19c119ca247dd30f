#include "script/author_text.h"

#include <gtest/gtest.h>

namespace mjcourse {

// "line:column+width" for an exception at UTF-16 column `column` of line `line`.
std::string place(const std::string& text, int line, int column, std::vector<std::string> tokens) {
  Exception exception;
  exception.column = column;
  exception.tokens = std::move(tokens);
  ScriptError error;
  AuthorText(text).point_at(exception, line, error);
  return std::to_string(error.line) + ":" + std::to_string(error.column) + "+" +
         std::to_string(error.width);
}

TEST(AuthorTextTest, TakesTheTokenNearestToTheColumn) {
  EXPECT_EQ(place("a.b + a.c + a.b", 1, 2, {"a.b"}), "1:1+3");
  EXPECT_EQ(place("a.b + a.c + a.b", 1, 14, {"a.b"}), "1:13+3");
  EXPECT_EQ(place("one\n  two", 2, 4, {"two"}), "2:3+3");
}

TEST(AuthorTextTest, TakesOnlyWholeNames) {
  EXPECT_EQ(place("xq + q + qx", 1, 1, {"q"}), "1:6+1");
  EXPECT_EQ(place("f[1] + f[12]", 1, 12, {"f[1]"}), "1:1+4");
}

TEST(AuthorTextTest, TriesTokensInTurn) {
  EXPECT_EQ(place("data.qpos[i]", 1, 10, {"data.qpos[13]", "data.qpos"}), "1:1+9");
}

TEST(AuthorTextTest, FallsBackToWhatIsCalledThere) {
  EXPECT_EQ(place("x = a.run(1)", 1, 10, {}), "1:5+5");
  EXPECT_EQ(place("x = (1)", 1, 5, {"y"}), "1:5+1");
}

TEST(AuthorTextTest, WithoutAColumnATokenMustStandOnce) {
  EXPECT_EQ(place("  f(1;", 1, 0, {";"}), "1:6+1");
  EXPECT_EQ(place("  f(1; 2);", 1, 0, {";"}), "1:3+8");
}

TEST(AuthorTextTest, ColumnsCountCharacters) {
  EXPECT_EQ(place("'é𝄞' + a.b", 1, 9, {"b"}), "1:10+1");
  EXPECT_EQ(place("'é𝄞' + f(1)", 1, 10, {}), "1:8+1");
}

TEST(AuthorTextTest, PastTheLastLineTheTextEndedTooEarly) {
  EXPECT_EQ(place("f(\n1 ;\n\n", 5, 0, {}), "2:2+1");
}

}  // namespace mjcourse
