#include "page/course_data.h"

#include <gtest/gtest.h>

#include <string>

#include "reading_of.h"

namespace mjcourse {
namespace {

// Levels of four lessons, and a guide of one beside them.
Course course_of_levels(int count) {
  Course course;
  const auto add = [&](const std::string& folder, const std::string& number) {
    course.levels.back().lessons.push_back(course.lessons.size());
    course.add(std::move(
        reading_of_file("---\ntitle: T\n---\n", "content/" + folder + "/" + number + "-x.md")
            .lesson.value()));
  };
  for (int i = 1; i <= count; ++i) {
    const std::string level = std::to_string(i);
    course.levels.push_back({level + "-level", "Level " + level, level, {}});
    for (int n = 1; n <= 4; ++n) add(level + "-level", level + "." + std::to_string(n));
  }
  course.levels.push_back({"guide", "Guide", "", {}});
  add("guide", "A.1");
  return course;
}

// "Level 1 (4), Level 2 → href, …": how many lessons are listed, or where the link leads.
std::string listed(const Course& course, const Lesson* current) {
  std::string text;
  for (const nlohmann::json& level : levels_data(course, current)) {
    const std::string href = level["href"];
    const std::string shown =
        href.empty() ? "(" + std::to_string(level["lessons"].size()) + ")" : "-> " + href;
    text += level["title"].get<std::string>() + " " + shown + "\n";
  }
  return text;
}

TEST(LevelsData, ListAllLessonsOfAShortCourse) {
  const Course course = course_of_levels(3);
  EXPECT_EQ(listed(course, &course.lessons[5]),
            "Level 1 (4)\nLevel 2 (4)\nLevel 3 (4)\nGuide (1)\n");
  EXPECT_EQ(levels_data(course, &course.lessons[5])[1]["lessons"][1]["current"], true);
  EXPECT_EQ(listed(course, nullptr), listed(course, &course.lessons[5]));
}

TEST(LevelsData, ListOneLevelOfALongCourseAndLinkThoseAroundIt) {
  const Course course = course_of_levels(30);
  std::string expected;
  for (int level = 12; level <= 18; ++level) {
    const std::string number = std::to_string(level);
    expected += "Level " + number +
                (level == 15 ? " (4)" : " -> index.html#level-" + number + "-level-title") + "\n";
  }
  expected += "Guide -> index.html#level-guide-title\n";
  EXPECT_EQ(listed(course, course.find_lesson("15.2")), expected);
}

TEST(LevelsData, LinkTheFirstLevelsOfALongCourseFromAPageOfNone) {
  const Course course = course_of_levels(30);
  const std::string list = listed(course, nullptr);
  EXPECT_TRUE(list.starts_with("Level 1 -> index.html#level-1-level-title\n"));
  EXPECT_TRUE(
      list.ends_with("Level 4 -> index.html#level-4-level-title\n"
                     "Guide -> index.html#level-guide-title\n"));
}

// The titles of the pages beside the lessons of a course whose one lesson begins with `front`.
std::string pages_beside(const std::string& front) {
  Course course;
  course.add(
      std::move(reading_of_file("---\n" + front +
                                    "---\n```quiz\n{\"id\": \"q\", \"questions\": [{\"kind\": "
                                    "\"numeric\", \"q\": \"?\", \"answer\": 1}]}\n```\n",
                                "content/1-a/1.1-x.md")
                    .lesson.value()));
  std::string titles;
  for (const nlohmann::json& page : pages_data(course, {}, has_questions(course), "progress")) {
    titles += page["title"].get<std::string>() + (page["current"] == true ? "!" : "") + " ";
  }
  return titles;
}

TEST(PagesData, HaveAReviewWhereThereIsAQuestion) {
  EXPECT_EQ(pages_beside("title: T\n"), "Review Your progress! On this device ");
  EXPECT_EQ(pages_beside("title: T\ndraft: true\n"), "Your progress! On this device ");
}

}  // namespace
}  // namespace mjcourse
