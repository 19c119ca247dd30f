#include "course/course_listing.h"

#include <gtest/gtest.h>

namespace mjcourse {
namespace {

const std::string kBlock = R"(# My course
title: C  # short
levels:
  - folder: 1-state   # the first
    title: State
    lessons: [1.2-b]   # more to come

  # Not numbered.
  - folder: guide
    title: Guide
    lessons:
      - A.1-x  # begin here
      # - A.2-later
      - A.3-z
macros: {"\\R": "\\mathbb{R}"}
)";

TEST(ReadListing, FindsLevelsAndLessons) {
  const auto levels = read_listing(kBlock).value();
  ASSERT_EQ(levels.size(), 2U);
  EXPECT_EQ(levels[0].folder, "1-state");
  EXPECT_EQ(levels[0].number, "1");
  EXPECT_EQ(levels[1].number, "");
  EXPECT_EQ(levels[1].lessons, (std::vector<std::string>{"A.1-x", "A.3-z"}));
}

TEST(ReadListing, RefusesWhatIsNoCourseFile) {
  for (const char* yaml :
       {"", "levels: 3\n", "title: C\n", "levels: [{title: A}]\n", "levels: [\n", "[1]\n",
        "levels: [{folder: a, lessons: b}]\n", "levels: [{folder: a, lessons: [[b]]}]\n"}) {
    EXPECT_FALSE(read_listing(yaml)) << yaml;
  }
}

TEST(WithLevel, ComesBehindSmallerNumbersAndKeepsTheRest) {
  EXPECT_EQ(with_level(kBlock, "2-dynamics", "Dynamics").value(), R"(# My course
title: C  # short
levels:
  - folder: 1-state   # the first
    title: State
    lessons: [1.2-b]   # more to come

  - folder: 2-dynamics
    title: Dynamics
    lessons: []

  # Not numbered.
  - folder: guide
    title: Guide
    lessons:
      - A.1-x  # begin here
      # - A.2-later
      - A.3-z
macros: {"\\R": "\\mathbb{R}"}
)");
}

TEST(WithLevel, ComesFirstWithTheSmallestNumber) {
  EXPECT_EQ(with_level("levels:\n- folder: 2-b\n  title: B\n", "1-a", "A").value(),
            "levels:\n- folder: 1-a\n  title: A\n  lessons: []\n- folder: 2-b\n  title: B\n");
}

TEST(WithLevel, ComesLastWithoutANumber) {
  const std::string after = with_level(kBlock, "notes", "Notes").value();
  EXPECT_NE(after.find("      - A.3-z\n\n  - folder: notes\n    title: Notes\n    lessons: []\n"
                       "macros: "),
            std::string::npos)
      << after;
}

TEST(WithLevel, QuotesTitlesThatYamlWouldReadOtherwise) {
  const std::string yaml = "levels:\n  - folder: 1-a\n    title: A\n";
  for (const auto& [title, written] :
       std::vector<std::pair<std::string, std::string>>{{"Rigid bodies", "Rigid bodies"},
                                                        {"Forces: a start", "\"Forces: a start\""},
                                                        {"yes", "\"yes\""},
                                                        {"null", "\"null\""},
                                                        {"2nd", "\"2nd\""},
                                                        {"\"Hi\" # not", "\"\\\"Hi\\\" # not\""},
                                                        {"Kräfte", "\"Kräfte\""}}) {
    EXPECT_EQ(with_level(yaml, "2-b", title).value_or("nothing"),
              yaml + "  - folder: 2-b\n    title: " + written + "\n    lessons: []\n");
  }
}

TEST(WithLevel, ComesIntoBracketsToo) {
  EXPECT_EQ(with_level("levels: [{folder: 1-a, title: 'A, ]'}] # }\n", "2-b", "B").value(),
            "levels: [{folder: 1-a, title: 'A, ]'}, {folder: 2-b, title: B, lessons: []}] # }\n");
}

TEST(WithLesson, ComesBehindItsLastLesson) {
  const std::string after = with_lesson(kBlock, "guide", "A.4-w").value();
  EXPECT_NE(after.find("      - A.3-z\n      - A.4-w\nmacros: "), std::string::npos) << after;
}

TEST(WithLesson, ComesAheadOfTheFirstWithAGreaterNumber) {
  const std::string after = with_lesson(kBlock, "guide", "A.2-y").value();
  EXPECT_NE(after.find("      - A.1-x  # begin here\n      - A.2-y\n      # - A.2-later\n"),
            std::string::npos)
      << after;
  EXPECT_NE(with_lesson(kBlock, "1-state", "1.1-a")
                .value()
                .find("    lessons: [1.1-a, 1.2-b]   # more to come\n"),
            std::string::npos);
}

TEST(WithLesson, FillsAnEmptyListAndAMissingOne) {
  EXPECT_EQ(with_lesson("levels:\n  - folder: 1-a\n    lessons: []\n", "1-a", "1.1-x").value(),
            "levels:\n  - folder: 1-a\n    lessons: [1.1-x]\n");
  EXPECT_EQ(with_lesson("levels:\n  - folder: 1-a\n    title: A", "1-a", "1.1-x").value(),
            "levels:\n  - folder: 1-a\n    title: A\n    lessons: [1.1-x]");
}

TEST(WithLesson, KeepsAListOfALineForEach) {
  const std::string before =
      "levels:\r\n- folder: 1-a\r\n  lessons: [\r\n    1.1-x,\r\n    1.3-z  # last\r\n  ]\r\n";
  EXPECT_EQ(with_lesson(before, "1-a", "1.4-q").value(),
            "levels:\r\n- folder: 1-a\r\n  lessons: [\r\n    1.1-x,\r\n    1.3-z,  # last\r\n"
            "    1.4-q\r\n  ]\r\n");
  EXPECT_EQ(with_lesson(before, "1-a", "1.2-y").value(),
            "levels:\r\n- folder: 1-a\r\n  lessons: [\r\n    1.1-x,\r\n    1.2-y,\r\n"
            "    1.3-z  # last\r\n  ]\r\n");
}

TEST(WithLesson, RefusesALayoutThatItDoesNotUnderstand) {
  // A list that two levels share, a tag before the list, a key without a value.
  for (const char* yaml :
       {"levels:\n  - folder: 1-a\n    lessons: &l\n      - 1.1-x\n  - folder: 2-b\n    lessons: "
        "*l\n",
        "levels:\n  - folder: 1-a\n    lessons: &l [1.1-x]\n  - folder: 2-b\n    lessons: *l\n",
        "levels:\n  - folder: 1-a\n    lessons: !!seq [1.1-x]\n",
        "levels:\n  - folder: 1-a\n    lessons:\n", "levels: [{folder: 1-a}]\n"}) {
    EXPECT_FALSE(with_lesson(yaml, "1-a", "1.2-y")) << with_lesson(yaml, "1-a", "1.2-y").value();
  }
}

}  // namespace
}  // namespace mjcourse
