#include "evaluate/answers/formula.h"

#include <gtest/gtest.h>

#include "evaluate/evaluation_of.h"

namespace mjcourse {
namespace {

TEST(Formula, BecomesMarkup) {
  const EvaluationOf found("Inline $x^2$.\n");
  EXPECT_EQ(found.mistakes(), "");
  EXPECT_NE(found.result<FormulaResult>().markup.find("katex"), std::string::npos);
  EXPECT_EQ(found.tally().formulas, 1);
}

TEST(Formula, UsesTheCoursesMacros) {
  const std::string yaml =
      "title: C\nmacros: {\\half: '\\frac{1}{2}'}\n"
      "levels: [{folder: 1-a, title: A, lessons: [1.1-x]}]\n";
  EXPECT_EQ(evaluated_mistakes("$\\half$\n", {{"content/course.yaml", yaml}}), "");
  EXPECT_NE(evaluated_mistakes("$\\half$\n"), "");
}

TEST(Formula, ShowsItsMistakeWhereItStands) {
  const EvaluationOf found("> Of é $a + \\alhpa$ and\n> $$\n> b \\\\\n> \\frc{1}{2}\n> $$\n");
  EXPECT_EQ(found.tally().formulas, 0);
  ASSERT_EQ(found.diagnostics().size(), 2u);
  const Place inline_place = found.diagnostics()[0].place,
              block_place = found.diagnostics()[1].place;
  EXPECT_EQ(found.diagnostics()[0].id, "E-math");
  EXPECT_EQ(inline_place.line, 4);
  EXPECT_EQ(inline_place.column, 13);
  EXPECT_EQ(inline_place.width, 6);
  EXPECT_EQ(block_place.line, 7);
  EXPECT_EQ(block_place.column, 3);
}

TEST(Formula, HasTenThousandBytesAtMost) {
  const std::string x(9'999, 'x');
  EXPECT_EQ(evaluated_mistakes("$" + x + "y$\n"), "");
  const std::string mistakes = evaluated_mistakes("$" + x + "yz$\n");
  EXPECT_TRUE(mistakes.starts_with(
      "content/1-a/1.1-x.md:4:2: error: a formula may have 10000 bytes, and this one has 10001 "
      "[E-math]\n"))
      << mistakes;
  EXPECT_TRUE(mistakes.ends_with(
      "  cure: say it in several; numbers by the hundred are a table or a plot\n"))
      << mistakes;
}

// A letter of the lesson is ten thousand of the page.
TEST(Formula, HasItsPartOfALesson) {
  const std::string many(4'900, 'x');
  const std::string yaml = "title: C\nmacros: {\\a: '\\b\\b', \\b: '" + many +
                           "'}\nlevels: [{folder: 1-a, title: A, lessons: [1.1-x]}]\n";
  std::string text;
  for (int i = 0; i < 1000; ++i) text += "$\\a$\n";
  const std::string mistakes = evaluated_mistakes(text, {{"content/course.yaml", yaml}});
  const std::size_t place = mistakes.find(": error: ");
  EXPECT_EQ(
      mistakes.substr(place, mistakes.find('\n') - place),
      ": error: the formulas of this lesson are more than 32 MiB of HTML up to here [E-math]");
  EXPECT_TRUE(mistakes.ends_with(
      "  cure: make several lessons of it, or shorten what its macros are written out to\n"))
      << mistakes;
}

}  // namespace
}  // namespace mjcourse
