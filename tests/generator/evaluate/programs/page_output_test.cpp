#include "evaluate/programs/page_output.h"

#include <gtest/gtest.h>

#include "reading_of.h"

namespace mjcourse {
namespace {

// What is said of a program that is `page` in the page.
std::string mistakes_in_page(const PageRun& page, const std::string& more = "") {
  const ReadingOf reading = reading_of("```cpp file=examples/a.cpp\nx;\n```\n" + more);
  Diagnostics found;
  compare_page_run(reading.only<Example>(), page, reading.lesson.value(), found);
  return found.empty() ? "" : found.front().message + "\n" + found.front().detail;
}

PageRun printing(const std::string& native, const std::string& page) {
  return {"", PageRun::Outputs{native, page}, ""};
}

TEST(PageOutput, AgreesWithinOneUnitOfTheLastPlace) {
  EXPECT_EQ(mistakes_in_page(printing("1.24\n", "1.25\n")), "");
  EXPECT_EQ(mistakes_in_page({}), "");
  EXPECT_EQ(mistakes_in_page({"it draws", {}, ""}), "");
}

TEST(PageOutput, IsShownByItsFirstLine) {
  EXPECT_EQ(mistakes_in_page(printing("a\n1.24\n", "a\n1.26\n")),
            "in the page, the program prints something else: `1.26` instead of `1.24`, in line 2\n"
            "2 - 1.24\n"
            "  + 1.26\n");
  EXPECT_NE(mistakes_in_page(printing("a\n", "a\nb\n")).find("`b` instead of nothing, in line 2"),
            std::string::npos);
}

TEST(PageOutput, MayDifferWhereTheLessonLeavesItOpen) {
  EXPECT_EQ(mistakes_in_page(printing("took 3 s\n", "took 4 s\n"), "```text\ntook [..] s\n```\n"),
            "");
  EXPECT_EQ(mistakes_in_page(printing("1.0\n", "1.4\n"), "```text tol=0.5\n1.2\n```\n"), "");
  EXPECT_NE(mistakes_in_page(printing("1.0\n", "1.4\n"), "```text\n1.0\n```\n"), "");
}

TEST(PageOutput, IsNotLookedAtWhereTheRunWentOtherwise) {
  EXPECT_EQ(mistakes_in_page({"", PageRun::Outputs{"a\n", "b\n"}, "exits with code 3"}),
            "in the page, the program exits with code 3\n");
}

}  // namespace
}  // namespace mjcourse
