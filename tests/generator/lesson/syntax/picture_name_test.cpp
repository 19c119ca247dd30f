#include "lesson/syntax/picture_name.h"

#include <gtest/gtest.h>

namespace mjcourse {
namespace {

// `text` as it stands in a lesson of nothing else.
LocatedText alone(const std::string& text) {
  return located({"x.md", text}, {0, text.size()});
}

std::string file_of(const std::string& target) {
  return file_of_target(alone(target)).text;
}

std::string blanks_in(const std::string& text) {
  std::string all;
  for (const LocatedText& name : names_with_blanks(alone(text), 0)) {
    all += name.text + "@" + std::to_string(name.span().begin) + "|";
  }
  return all;
}

TEST(PictureName, IsTheTargetWithItsEscapesPutRight) {
  EXPECT_EQ(file_of("my%20arm.png"), "my arm.png");
  EXPECT_EQ(file_of("gr%C3%B6%c3%9fe.png"), "größe.png");
  EXPECT_EQ(file_of("100%.png"), "100%.png");
  EXPECT_EQ(file_of("a%2525.png"), "a%25.png");
}

TEST(PictureName, HasNoByteThatNoNameHas) {
  EXPECT_EQ(file_of("a%00b%0Ac%7F.png"), "a%00b%0Ac%7F.png");
  EXPECT_EQ(file_of("a%20b%FF.png"), "a%20b%FF.png");
}

TEST(PictureName, KnowsWhereItsBytesStand) {
  const LocatedText file = file_of_target(alone("a%20b.png"));
  EXPECT_EQ(file.span(1, 2).begin, 1U);
  EXPECT_EQ(file.span(2, 3).begin, 4U);
  EXPECT_EQ(file.span().end, 9U);
}

TEST(PictureName, IsWrittenSoThatItIsReadAgain) {
  EXPECT_EQ(target_of_file("arm.png"), "arm.png");
  EXPECT_EQ(target_of_file("my arm (2).png"), "<my arm (2).png>");
  EXPECT_EQ(target_of_file("100%.png"), "100%.png");
  for (const std::string file : {"a%20b.png", "50%25.png", "a b%41.png"}) {
    std::string target = target_of_file(file);
    if (target.starts_with('<')) target = target.substr(1, target.size() - 2);
    EXPECT_EQ(file_of(target), file) << target;
  }
}

TEST(PictureName, WithABlankIsTextToMarkdown) {
  EXPECT_EQ(blanks_in("![An arm](my arm.png) and [b](x y.SVG \"t\")"), "my arm.png@10|x y.SVG@30|");
  EXPECT_EQ(blanks_in("![a](arm.png \"my arm.png\") ![b](<my arm.png>) [c\\](my arm.png)"), "");
  EXPECT_EQ(blanks_in("![a](my arm.txt)\n\n![b](my arm.png)"), "");
}

}  // namespace
}  // namespace mjcourse
