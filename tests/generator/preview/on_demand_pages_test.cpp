#include "preview/on_demand_pages.h"

#include <gtest/gtest.h>

#include "base/files.h"
#include "base/temporary_folder.h"

namespace mjcourse {
namespace {

// A browser whose tab stayed open asks before anything is known.
TEST(OnDemandPages, HasNothingBeforeTheFirstSnapshot) {
  const TemporaryFolder course;
  OnDemandPages pages(course.path(), MJCOURSE_ASSETS, "", "");
  const OnDemandPages::Page page = pages.page("index.html");
  EXPECT_EQ(page.html, "");
  EXPECT_EQ(page.snapshot, nullptr);
  EXPECT_FALSE(page.fault);
  EXPECT_EQ(pages.file("1-a/1.1-b/figure-1.png"), std::nullopt);
}

TEST(OnDemandPages, KeepsAPageThatCannotBeMadeAnyMore) {
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
  OnDemandPages pages(course.path(), MJCOURSE_ASSETS, "", "");
  pages.show(known);
  const std::string html = pages.page("1-a/1.1-b.html").html;
  EXPECT_NE(html.find("<p>Text.</p>"), std::string::npos);
  EXPECT_EQ(pages.page("1-a/1.2-c.html").html, "");

  pages.show(std::make_shared<Snapshot>());  // of a course that cannot be read
  EXPECT_EQ(pages.page("1-a/1.1-b.html").html, html);
}

}  // namespace
}  // namespace mjcourse
