#include <gtest/gtest.h>

#include "reading_of.h"

namespace mjcourse {
namespace {

// The formulas of `body`, each in its dollars.
std::vector<std::string> formulas(const std::string& body) {
  const ReadingOf reading = reading_of(body);
  EXPECT_EQ(reading.mistakes(), "");
  std::vector<std::string> found;
  for (const Math* math : reading.all<Math>()) {
    const std::string dollars = math->display ? "$$" : "$";
    found.push_back(dollars + math->tex.text + dollars);
  }
  return found;
}

// What a reader sees of `body`, formulas as TeX.
std::string prose(const std::string& body) {
  return plain_text(reading_of(body).lesson->document.get());
}

using Formulas = std::vector<std::string>;

TEST(Math, IsNotMoney) {
  EXPECT_EQ(formulas("It costs $5 and $6."), Formulas{});
  EXPECT_EQ(formulas("It costs $5 and $6, and $x$ is free."), Formulas{"$x$"});
  EXPECT_EQ(formulas("$20,000 and USD$30,000"), Formulas{});
  EXPECT_EQ(prose("It costs $5 and $6, and $x$."), "It costs $5 and $6, and x.");
}

TEST(Math, BeginsWithNoSpaceAndEndsAfterNone) {
  EXPECT_EQ(formulas("a $ x$ b"), Formulas{});
  EXPECT_EQ(formulas("a $x $ b"), Formulas{});
  EXPECT_EQ(formulas("a $x$5 b"), Formulas{});
  EXPECT_EQ(formulas("a ($x$), b"), Formulas{"$x$"});
}

TEST(Math, IsUntouchedByEmphasisCodeAndHtml) {
  EXPECT_EQ(formulas("$a_b*c*$ and *$d*e$* and $<b>$"), (Formulas{"$a_b*c*$", "$d*e$", "$<b>$"}));
  EXPECT_EQ(formulas("$a`b`c$ but `$code$`"), Formulas{"$a`b`c$"});
}

TEST(Math, KeepsItsBackslashes) {
  EXPECT_EQ(formulas(R"($\alpha\\[1ex]\_\$5$)"), Formulas{R"($\alpha\\[1ex]\_\$5$)"});
  EXPECT_EQ(prose(R"(\$x$ and \$\$)"), "$x$ and $$");
}

TEST(Math, IsDisplayedBetweenTwoDollars) {
  EXPECT_EQ(formulas("$$x^2$$\n\nText $$y$$ goes on.\n\n$$z$$ begins."),
            (Formulas{"$$x^2$$", "$$y$$", "$$z$$"}));
}

TEST(MathBlock, MayHoldLinesThatLookLikeMarkdown) {
  EXPECT_EQ(formulas("$$\na\n+ b\n- c\n= d\n> e\n\n1. f\n# g\n$$\n"),
            Formulas{"$$\na\n+ b\n- c\n= d\n> e\n\n1. f\n# g\n$$"});
}

TEST(MathBlock, StandsInQuotesAndLists) {
  EXPECT_EQ(formulas("> $$\n> a\n> + b\n> $$\n> after\n\n- $$\n  c\n  $$\n"),
            (Formulas{"$$\na\n+ b\n$$", "$$\nc\n$$"}));
}

// As KaTeX counts them.
TEST(Math, MayHoldDollarsInItsText) {
  EXPECT_EQ(formulas("$f \\text{ if $x>0$ and $y<0$}$, $z$"),
            (Formulas{"$f \\text{ if $x>0$ and $y<0$}$", "$z$"}));
  EXPECT_EQ(formulas("$\\text{a $b$} + c$."), Formulas{"$\\text{a $b$} + c$"});
  EXPECT_EQ(formulas("$\\{x\\}$ $\\left\\{ y$ ${z}$"),
            (Formulas{"$\\{x\\}$", "$\\left\\{ y$", "${z}$"}));
  EXPECT_EQ(formulas("${HOME} and $x$"), Formulas{"$x$"});
}

// KaTeX says what is wrong then.
TEST(Math, EndsAtTheNextDollarWhereBracesAreMissing) {
  EXPECT_EQ(formulas("$a {b$ and $c$"), (Formulas{"$a {b$", "$c$"}));
}

TEST(Math, StandsInTables) {
  EXPECT_EQ(formulas("| $a$ | b |\n|---|---|\n| $x_1$ | $y$ |\n"),
            (Formulas{"$a$", "$x_1$", "$y$"}));
}

TEST(Math, KnowsItsPlace) {
  const ReadingOf reading =
      reading_of("é $x$, $x$\n\n> $$\n> a\n> b\n> $$\n\n| a |\n|---|\n| $z$ |");
  const auto math = reading.all<Math>();
  ASSERT_EQ(math.size(), 4u);
  EXPECT_EQ(reading.place(math[0]->tex), "4:4");
  EXPECT_EQ(reading.place(math[1]->tex), "4:9");
  EXPECT_EQ(reading.place(math[2]->tex, 1), "7:3");
  EXPECT_EQ(reading.place(math[2]->tex, 3), "8:3");
  EXPECT_EQ(reading.place(math[3]->tex), "13:4");
}

TEST(Math, MayRunOverALinesEnd) {
  const ReadingOf reading = reading_of("> A $multi\n> line$ formula.\n");
  EXPECT_EQ(reading.only<Math>().tex.text, "multi\nline");
  EXPECT_EQ(reading.place(reading.only<Math>().tex, 6), "5:3");
}

TEST(MathBlock, MustBeClosed) {
  EXPECT_EQ(mistakes_in("$$\na + b\n\nnever\n"),
            R"(content/1-a/1.1-x.md:4:1: error: this `$$` is never closed [E-math-unclosed]
  4 | $$
    | ^~
  cure: end the formula with `$$`
)");
  EXPECT_EQ(mistakes_in("> $$\n> in a quote\n\noutside\n"),
            R"(content/1-a/1.1-x.md:4:3: error: this `$$` is never closed [E-math-unclosed]
  4 | > $$
    |   ^~
  cure: end the formula with `$$`
)");
}

TEST(Math, MustBeClosedInAParagraphToo) {
  EXPECT_EQ(mistakes_in("Text $$ never closed\n"),
            R"(content/1-a/1.1-x.md:4:6: error: this `$$` is never closed [E-math-unclosed]
  4 | Text $$ never closed
    |      ^~
  cure: end the formula with `$$`; for dollars as text write `\$\$`
)");
}

TEST(Math, SaysWhichLineIsMissingAboveAFormula) {
  EXPECT_EQ(mistakes_in("The sum\n$$\na\n- b\n$$\n"),
            R"(content/1-a/1.1-x.md:5:1: error: this `$$` is never closed [E-math-unclosed]
  5 | $$
    | ^~
  cure: leave an empty line above it: right below text, the formula ends where a list, a quote or a heading may begin, at a line with `-`, `+`, `>` or `#`; then end it with `$$`
)");
  EXPECT_EQ(mistakes_in("> text\n> $$\n> + c\n>   $$\n"),
            R"(content/1-a/1.1-x.md:5:3: error: this `$$` is never closed [E-math-unclosed]
  5 | > $$
    |   ^~
  cure: leave an empty line above it: right below text, the formula ends where a list, a quote or a heading may begin, at a line with `-`, `+`, `>` or `#`; then end it with `$$`
)");
}

TEST(MathBlock, HasNothingBehindIt) {
  EXPECT_EQ(mistakes_in("$$\na\n$$ and more\n"),
            "content/1-a/1.1-x.md:6:3: error: text follows the `$$` that closes the formula "
            "[E-math-behind]\n"
            "  6 | $$ and more\n"
            "    |   ^~~~~~~~~\n"
            "  cure: begin it on a line of its own\n");
}

}  // namespace
}  // namespace mjcourse
