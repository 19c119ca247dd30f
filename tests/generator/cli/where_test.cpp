#include "cli/where.h"

#include <gtest/gtest.h>

#include "course/course_of.h"

namespace mjcourse {
namespace {

// Lesson 1.1 has text in line 4, and a fence in its lines 6 to 8.
const CourseOf& known() {
  static const CourseOf course = course_of("Text $x$.\n\n```sh unchecked\nls\n```", "Text $x$.\n");
  return course;
}

// "1.1 6-8" for a place in lesson 1.1, else why it is none.
std::string place(const std::string& text) {
  const auto where = find_place(known().course.value(), "/c", text);
  if (!where) return where.error();
  return where->lesson->number + " " + std::to_string(where->first) + "-" +
         std::to_string(where->last);
}

TEST(Where, IsALessonByItsNumberItsNameOrItsFile) {
  ASSERT_EQ(known().mistakes(), "");
  for (const char* name : {"1.2", "1.2-y", "content/1-a/1.2-y.md", "./content/1-a/1.2-y.md",
                           "/c/content/1-a/1.2-y.md"}) {
    EXPECT_EQ(place(name), "1.2 0-0") << name;
  }
}

TEST(Where, IsTheFenceAroundALine) {
  EXPECT_EQ(place("1.1:6"), "1.1 6-8");
  EXPECT_EQ(place("1.1-x:7"), "1.1 6-8");
  EXPECT_EQ(place("1.1:8"), "1.1 6-8");
  EXPECT_EQ(place("1.1:4"), "1.1 4-4");
}

TEST(Where, SaysWhichLessonsThereAre) {
  EXPECT_EQ(place("1.3"), "there is no lesson 1.3; did you mean `1.1`?");
  EXPECT_EQ(place("1.2-z:3"), "there is no lesson 1.2-z; did you mean `1.2-y`?");
  EXPECT_EQ(place("content/1-a/1.2-yy.md"),
            "there is no lesson content/1-a/1.2-yy.md; did you mean `content/1-a/1.2-y.md`?");
  EXPECT_EQ(place("nothing"), "there is no lesson nothing; known: 1.1, 1.2");
}

TEST(Where, SaysWhichLinesThereAre) {
  for (const char* line : {"0", "-1", "", "4x", "99999999999"}) {
    const std::string text = std::string("1.1:") + line;
    EXPECT_EQ(place(text), text + " names no line; write it as 1.1:210");
  }
  EXPECT_EQ(place("1.1:90"), "content/1-a/1.1-x.md has only 8 lines");
  // The end of the last line begins no other.
  EXPECT_EQ(place("1.2:5"), "content/1-a/1.2-y.md has only 4 lines");
}

TEST(Where, HasThePlacesBetweenItsLines) {
  const Where all = find_place(known().course.value(), "/c", "1.1").value();
  const Where fence = find_place(known().course.value(), "/c", "1.1:7").value();
  const auto at = [](int line, const char* file = "content/1-a/1.1-x.md") {
    return Place{file, line, 1, 1, ""};
  };
  EXPECT_TRUE(all.has(at(1)) && all.has(at(8)));
  EXPECT_FALSE(all.has(at(1, "content/1-a/1.2-y.md")));
  EXPECT_TRUE(fence.has(at(6)) && fence.has(at(8)));
  EXPECT_FALSE(fence.has(at(5)) || fence.has(at(9)) || fence.has(at(7, "a.xml")));
}

}  // namespace
}  // namespace mjcourse
