#include "page/lesson_history.h"

#include <gtest/gtest.h>

#include "page/site_of.h"

namespace mjcourse {
namespace {

TEST(LessonHistory, WritesADayInWords) {
  EXPECT_EQ(day_in_words("2026-03-03"), "3 March 2026");
  EXPECT_EQ(day_in_words("2026-12-31"), "31 December 2026");
}

TEST(LessonHistory, SaysWhatIsKnown) {
  SiteOf site;
  const Lesson& lesson = site.course.lessons[0];
  EXPECT_EQ(history_data(site.data, lesson), nullptr);

  site.data.changes[lesson.source->path()] = {};  // not committed
  EXPECT_EQ(history_data(site.data, lesson), nullptr);

  site.data.changes[lesson.source->path()] = {"2026-03-03", "2026-03-04T04:30:00Z"};
  EXPECT_EQ(history_data(site.data, lesson),
            nlohmann::json::parse(R"({"day": "2026-03-03", "words": "3 March 2026", "edit": ""})"));

  site.data.changes.clear();
  site.course.edit = "https://example.org/edit/{path}";
  EXPECT_EQ(history_data(site.data, lesson), nlohmann::json::parse(R"({"day": "", "words": "",
                "edit": "https://example.org/edit/content/1-a/1.1-x.md"})"));
}

}  // namespace
}  // namespace mjcourse
