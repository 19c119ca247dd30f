#include "evaluate/programs/page_output.h"

#include <gtest/gtest.h>

#include "reading_of.h"

namespace mjcourse {
namespace {

// What is said where the program printed `native`, and in the page what `page` has.
std::string mistakes_in_page(const std::string& native, PageRun page,
                             const std::string& more = "") {
  const ReadingOf reading = reading_of("```cpp file=examples/a.cpp\nx;\n```\n" + more);
  ExampleResult result{"x;\n", native};
  result.page = std::move(page);
  Diagnostics found;
  compare_page_run(reading.only<Example>(), result, reading.lesson.value(), found);
  return found.empty() ? "" : found.front().message + "\n" + found.front().detail;
}

PageRun page_printing(const std::string& output) {
  return {"", output, ""};
}

TEST(PageOutput, AgreesWithinOneUnitOfTheLastPlace) {
  EXPECT_EQ(mistakes_in_page("1.24\n", page_printing("1.25\n")), "");
  EXPECT_EQ(mistakes_in_page("1.24\n", {}), "");
  EXPECT_EQ(mistakes_in_page("1.24\n", {"it draws", {}, ""}), "");
}

TEST(PageOutput, IsShownByItsFirstLine) {
  EXPECT_EQ(mistakes_in_page("a\n1.24\n", page_printing("a\n1.26\n")),
            "in the page, the program prints something else: `1.26` instead of `1.24`, in line 2\n"
            "2 - 1.24\n"
            "  + 1.26\n");
  EXPECT_NE(
      mistakes_in_page("a\n", page_printing("a\nb\n")).find("`b` instead of nothing, in line 2"),
      std::string::npos);
}

TEST(PageOutput, MayDifferWhereTheLessonLeavesItOpen) {
  EXPECT_EQ(
      mistakes_in_page("took 3 s\n", page_printing("took 4 s\n"), "```text\ntook [..] s\n```\n"),
      "");
  EXPECT_EQ(mistakes_in_page("1.0\n", page_printing("1.4\n"), "```text tol=0.5\n1.2\n```\n"), "");
  EXPECT_NE(mistakes_in_page("1.0\n", page_printing("1.4\n"), "```text\n1.0\n```\n"), "");
}

TEST(PageOutput, IsNotLookedAtWhereTheRunWentOtherwise) {
  EXPECT_EQ(mistakes_in_page("a\n", {"", "b\n", "exits with code 3"}),
            "in the page, the program exits with code 3\n");
}

}  // namespace
}  // namespace mjcourse
