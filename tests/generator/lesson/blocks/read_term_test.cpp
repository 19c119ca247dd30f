#include <gtest/gtest.h>

#include "lesson/syntax/term_syntax.h"
#include "reading_of.h"

namespace mjcourse {
namespace {

// Each term of a lesson with this body: its place, its key, what is shown.
std::string terms(const std::string& body) {
  const ReadingOf reading = reading_of(body);
  std::string text = underlined_mistakes(reading);
  for (std::size_t i = 0; i < reading.lesson->blocks.size(); ++i) {
    const auto* term = std::get_if<TermUse>(&reading.lesson->blocks[i]);
    if (term == nullptr) continue;
    text += reading.place(term->name) + " " + term->name.text + " = " + term->key + ", shown ";
    for (const auto& [node, index] : reading.lesson->block_of) {
      if (index == i) text += plain_text(const_cast<cmark_node*>(node)) + "\n";
    }
  }
  return text;
}

TEST(Term, IsItsNameOrShowsAnotherText) {
  EXPECT_EQ(terms("A [[Free  joint]].\n"), "4:5 Free  joint = free joint, shown Free  joint\n");
  EXPECT_EQ(terms("A [[free joint|free *one*]].\n"),
            "4:5 free joint = free joint, shown free one\n");
  EXPECT_EQ(terms("A [[`qpos`]].\n"), "4:5 `qpos` = qpos, shown qpos\n");
  EXPECT_EQ(terms("A [[a|]].\n"), "4:5 a = a, shown a\n");
}

TEST(Term, IsFoundWhereTheAuthorWroteIt) {
  EXPECT_EQ(terms("`[[a]]` and $[[b]]$ and [[c]]\n"), "4:27 c = c, shown c\n");
  EXPECT_EQ(terms("| a |\n|---|\n| [[b\\|c]] |\n"), "6:5 b = b, shown c\n");
  EXPECT_EQ(terms("[[`a`]] `a`, `b\nc`, [[d|`d`]] `d` [[e]] `a`\n\n`b c` `a`\n"),
            "4:3 `a` = a, shown a\n5:7 d = d, shown d\n5:21 e = e, shown e\n");
  EXPECT_EQ(terms("> x\n> [[b]]\n"), "5:5 b = b, shown b\n");
  EXPECT_EQ(terms("```io\nINPUT: a [[b]]\n```\n"), "5:12 b = b, shown b\n");
}

TEST(Term, IsNotEveryPairOfBrackets) {
  EXPECT_EQ(terms("a[[0]] \\[[b]] \\[\\[c]] [\\[d]] [[]] [[[1], [2]]] [[ e\n"), "");
  EXPECT_EQ(terms("\\[[b]] [[c]]\n"), "4:10 c = c, shown c\n");
}

TEST(Term, MustBeClosedOnItsLine) {
  EXPECT_EQ(terms("A [[free\njoint]].\n"),
            "E-term-unclosed <[[> no `]]` closes this term on its line | write `[[term]]`, in a "
            "table `[[term\\|shown text]]`; `\\[[` for brackets as text\n");
}

TEST(Term, CannotStandInATitle) {
  EXPECT_EQ(terms("> [!note] A [[b]]\n> Text.\n"),
            "E-term-place <b> a term cannot stand in a callout's title | a term is a link itself: "
            "put it where the text first speaks of it\n");
}

TEST(Term, CannotStandInAnotherLink) {
  EXPECT_EQ(terms("[see [[a]]](https://a.example)\n\n## The [[a]]\n"),
            "E-term-place <a> a term cannot stand in the text of a link | a term is a link itself: "
            "put it where the text first speaks of it\n"
            "E-term-place <a> a term cannot stand in a heading | a term is a link itself: put it "
            "where the text first speaks of it\n");
}

}  // namespace
}  // namespace mjcourse
