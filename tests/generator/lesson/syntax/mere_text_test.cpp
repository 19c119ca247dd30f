#include "lesson/syntax/mere_text.h"

#include <gtest/gtest.h>

#include "reading_of.h"

namespace mjcourse {
namespace {

// Each by its id and what is underlined.
std::string found(const std::string& body) {
  std::string text;
  for (const Diagnostic& d : reading_of(body).diagnostics) {
    const auto column = static_cast<std::size_t>(d.place.column - 1);
    text += (text.empty() ? "" : ", ") + d.id + " <" +
            d.place.excerpt.substr(column, static_cast<std::size_t>(d.place.width)) + ">";
  }
  return text;
}

TEST(MereText, IsAReferenceThatNothingDefines) {
  EXPECT_EQ(found("a[^x] b\n"), "W-footnote-unknown <[^x]>");
  EXPECT_EQ(found("[*t*][no], ![p][no]\n"),
            "W-reference-unknown <[*t*][no]>, W-reference-unknown <![p][no]>");
  EXPECT_EQ(found("[no][] and ![no]\n"),
            "W-reference-unknown <[no][]>, W-reference-unknown <![no]>");
  EXPECT_EQ(found("> - [t][no]\n"), "W-reference-unknown <[t][no]>");
  EXPECT_EQ(found("| a |\n|---|\n| [t][no] |\n"), "W-reference-unknown <[t][no]>");
  EXPECT_EQ(found("## [t][no]\n"), "W-reference-unknown <[t][no]>");
  EXPECT_EQ(found("> [!note] [t][no]\n> text\n"), "W-reference-unknown <[t][no]>");
  EXPECT_EQ(found("[\"t\"][it's] [t][\"no\"] ![a--b...] a[^it's]\n"),
            "W-reference-unknown <[\"t\"][it's]>, W-reference-unknown <[t][\"no\"]>, "
            "W-reference-unknown <![a--b...]>, W-footnote-unknown <[^it's]>");
}

TEST(MereText, IsNotWhatIsDefinedCodeOrEscaped) {
  EXPECT_EQ(found("[t][yes] [yes][] [yes] a[^b]\n\n[yes]: https://example.org\n\n[^b]: c\n"), "");
  EXPECT_EQ(found("`a[^x]` `[t][no]` $a[b][c]$ \\[^x\\] \\[t][no] [1] [x] data[i][j] f()[a][b]\n"),
            "");
  EXPECT_EQ(found("```text unchecked\n[^x] [t][no] \\(x\\)\n```\n"), "");
  EXPECT_EQ(found("- [x] done\n- [ ] not\n"), "");
}

TEST(MereText, IsANoteAsOthersWriteThem) {
  EXPECT_EQ(found("a[^long name] b^[a *note*] c^[a note]\n\n[^long name]: d e\n"),
            "W-footnote-unknown <[^long name]>, W-footnote-unknown <^[a *note*]>, "
            "W-footnote-unknown <^[a note]>, "
            "W-footnote-unknown <[^long name]>");
  EXPECT_EQ(found("x^[2] \\[^a b] `^[a b]` [^ \\t]\n"), "");
}

TEST(MereText, IsATableAsOthersWriteThem) {
  EXPECT_EQ(found("+---+---+\n| a | b |\n+===+===+\n| 1 | 2 |\n+---+---+\n"),
            "W-table-head <+---+---+>");
  EXPECT_EQ(found("> | a |\n> | === |\n"), "W-table-head <| === |>");
  EXPECT_EQ(found("| a |\n|---|\n\n| 1 |\n| 2 |\n"), "W-table-head <| 1 |>");
  EXPECT_EQ(found("| a |\n|---|\n| == |\n| — |\n\nIt is |x|, a + b – |c|.\n"), "");
}

TEST(MereText, IsALinkWithABlank) {
  EXPECT_EQ(found("[t](a b.html) ![p](my d.svg)\n"),
            "W-link-blank <[t](a b.html)>, E-image-blank <my d.svg>");
  EXPECT_EQ(found("[t](https://a.org \"b\") [t](https://a.org \"c) d\"\n"),
            "W-link-blank <[t](https://a.org \"c)>");
  EXPECT_EQ(
      found("[t](https://example.org \"a title\") [t](<https://example.org/a b>) [t] (a b)\n"), "");
}

TEST(MereText, IsAFormulaInBrackets) {
  EXPECT_EQ(found("a \\(x\\) b \\[ y \\] c\n\n\\[\nz\n\\]\n"),
            "W-math-brackets <\\(>, W-math-brackets <\\[>, W-math-brackets <\\[>");
  EXPECT_EQ(found("[t](https://a.org/\\(x_1\\)) [t](https://a.org/\\(b\\) \"c\") \\(x\\)\n"),
            "W-math-brackets <\\(>");
  EXPECT_EQ(found("\\[1\\], \\[a, b\\] and `\\(x\\)`, \\\\(x\\\\)\n"), "");
}

TEST(MereText, IsAFormulaWithoutDollars) {
  EXPECT_EQ(found("\\begin{equation}\nx = 1\n\\end{equation}\n\na \\begin{align*} b\n"),
            "W-math-brackets <\\begin{equation}>, W-math-brackets <\\begin{align*}>");
  EXPECT_EQ(
      found("$$\n\\begin{aligned}x\\end{aligned}\n$$\n\na\n$$\n\\begin{aligned}x\\end{aligned}\n"
            "$$\n\n$\\begin{matrix}a\\end{matrix}$ `\\begin{a}`\n"),
      "");
}

TEST(MereText, IsAHeadingWithoutABlank) {
  EXPECT_EQ(found("##Two\n\ntext\n###Three\n\n> ##Quoted\n"),
            "W-heading-blank <##>, W-heading-blank <###>, W-heading-blank <##>");
  EXPECT_EQ(found("- ##One\n  - ##Two\n\n1. ###Three\n\n> * ##Four\n"),
            "W-heading-blank <##>, W-heading-blank <##>, W-heading-blank <###>, "
            "W-heading-blank <##>");
  EXPECT_EQ(found("#include\n\n\\##a\n\n## b\n\n##\n\n`##a`\n"), "");
}

TEST(MereText, IsACommentThatIsNone) {
  EXPECT_EQ(found("a <!-- use --strict --> b\n"), "W-html-comment <<!-- use --strict -->>");
  EXPECT_EQ(found("a <!-- see [t][no] -- --> b\n\n## c <!--> d\n"),
            "W-html-comment <<!-- see [t][no] -- -->>, W-reference-unknown <[t][no]>, "
            "W-html-comment <<!-->");
  EXPECT_EQ(found("a <!-- is\nnever closed\n"), "W-html-comment <<!-->");
  EXPECT_EQ(found("a <!-- b --> c <!----> `<!-- d` \\<!-- $<!--$\n"), "");
  EXPECT_EQ(found("<!-- use --strict -->\n\ntext\n"), "");
}

}  // namespace
}  // namespace mjcourse
