#include "preview/page_room.h"

#include <gtest/gtest.h>

#include "base/files.h"
#include "base/temporary_folder.h"

namespace mjcourse {
namespace {

// A browser whose tab stayed open asks before anything is known.
TEST(PageRoom, HasNothingBeforeTheFirstSnapshot) {
  const TemporaryFolder course;
  PageRoom room(course.path(), MJCOURSE_ASSETS, "");
  const PageRoom::Page page = room.page("index.html");
  EXPECT_EQ(page.html, "");
  EXPECT_EQ(page.snapshot, nullptr);
  EXPECT_FALSE(page.fault);
  EXPECT_EQ(room.file("1-a/1.1-b/figure-1.png"), std::nullopt);
}

TEST(PageRoom, KeepsAPageThatCannotBeMadeAnyMore) {
  const TemporaryFolder course;
  write_file(course.path() / "content/course.yaml",
             "title: A course\nlevels:\n  - folder: 1-a\n    title: A\n    lessons: [1.1-b]\n");
  write_file(course.path() / "content/1-a/1.1-b.md", "---\ntitle: B\n---\n\nText.\n");
  auto known = std::make_shared<Snapshot>();
  known->course = read_course(DiskFiles(course.path()), known->diagnostics).value();
  auto results = std::make_shared<Evaluation>();
  results->lessons.resize(1);
  known->evaluation = results;
  known->readable = true;
  PageRoom room(course.path(), MJCOURSE_ASSETS, "");
  room.show(known);
  const std::string html = room.page("1-a/1.1-b.html").html;
  EXPECT_NE(html.find("<p>Text.</p>"), std::string::npos);
  EXPECT_EQ(room.page("1-a/1.2-c.html").html, "");

  room.show(std::make_shared<Snapshot>());  // of a course that cannot be read
  EXPECT_EQ(room.page("1-a/1.1-b.html").html, html);
}

}  // namespace
}  // namespace mjcourse
