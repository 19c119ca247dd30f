#include "lesson/markdown.h"

#include <gtest/gtest.h>

namespace mjcourse {
namespace {

std::string text_of(const std::string& markdown) {
  return plain_text(parse_markdown(markdown).get());
}

TEST(Markdown, SetsQuotesAndApostrophes) {
  EXPECT_EQ(text_of("It's 'so', \"they\" say."), "It’s ‘so’, “they” say.");
  EXPECT_EQ(text_of("one\n'two' and *'three'*"), "one ‘two’ and ‘three’");
}

TEST(Markdown, SetsAnApostropheBehindCodeFormulasAndEmphasis) {
  EXPECT_EQ(text_of("`qvel`'s size and the boxes' height"), "qvel’s size and the boxes’ height");
  EXPECT_EQ(text_of("$x$'s and *y*'s and [z](1.2)'s, all the boxes'"),
            "x’s and y’s and z’s, all the boxes’");
}

}  // namespace
}  // namespace mjcourse
