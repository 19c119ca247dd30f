#include "lesson/syntax/markdown.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace mjcourse {
namespace {

std::string text_of(const std::string& markdown, const Typography& typography = {}) {
  return plain_text(parse_markdown(markdown, {}, 1, nullptr, typography).get());
}

TEST(Markdown, SetsQuotesAndApostrophes) {
  EXPECT_EQ(text_of("It's 'so', \"they\" say."), "It’s ‘so’, “they” say.");
  EXPECT_EQ(text_of("one\n'two' and *'three'*"), "one ‘two’ and ‘three’");
}

TEST(Markdown, SetsAnApostropheBehindCodeFormulasAndEmphasis) {
  EXPECT_EQ(text_of("`qvel`'s size and the boxes' height"), "qvel’s size and the boxes’ height");
  EXPECT_EQ(text_of("$x$'s and *y*'s and [z](1.2)'s, all the boxes'"),
            "x’s and y’s and z’s, all the boxes’");
  EXPECT_EQ(text_of("'the `a`'s b' and <b>a</b>'s, all the boxes'"),
            "‘the a’s b’ and a’s, all the boxes’");
}

TEST(Markdown, EndsNoQuoteWithinAWord) {
  EXPECT_EQ(text_of("'90s don't end"), "’90s don’t end");
  EXPECT_EQ(text_of("'I don't, l'\u00e9t\u00e9'"), "‘I don’t, l’\u00e9t\u00e9’");
}

TEST(Markdown, SetsTheQuotesOfItsLanguage) {
  const Typography german{true, {"„", "“", "‚", "‘"}};
  EXPECT_EQ(text_of("\"Sag 'ja'\", 'so' geht's", german), "„Sag ‚ja‘“, ‚so‘ geht’s");
  EXPECT_EQ(text_of("(\"a\") *\"b\"* \"`c`\" [\"d\"](1.2)", german), "(„a“) „b“ „c“ „d“");
  EXPECT_EQ(text_of("“a” &ldquo;b&rdquo; \\\"c\\\" `\"d\"`", german), "“a” “b” \"c\" \"d\"");
  EXPECT_EQ(text_of("\"a \"b\" c\"", german), "„a „b“ c“");
}

TEST(Markdown, LeavesAllAsItIsTypedWhereItShall) {
  EXPECT_EQ(text_of("\"It's\" -- 'so'...", {false, {}}), "\"It's\" -- 'so'...");
}

TEST(Markdown, EndsWhereItIsTooDeep) {
  for (const std::string& text : {std::string(100'000, '>') + " a",
                                  std::string(60'000, '*') + "a" + std::string(60'000, '*')}) {
    std::vector<int> lines;
    const Document document =
        parse_markdown("b\n\n" + text, [&](Excess, int line) { lines.push_back(line); });
    EXPECT_EQ(lines, std::vector<int>{3});
    EXPECT_EQ(plain_text(document.get()), "b");
  }
}

TEST(Markdown, IsWholeBeforeThat) {
  const auto unexpected = [](Excess, int line) { ADD_FAILURE() << "in line " << line; };
  EXPECT_EQ(plain_text(parse_markdown(std::string(190, '>') + " a", unexpected).get()), "a");
}

}  // namespace
}  // namespace mjcourse
