// Which courses are printed as a whole.
#include "page/printed_course.h"

#include <gtest/gtest.h>

#include "page/site_of.h"

namespace mjcourse {
namespace {

TEST(PrintedLength, FitsUpToItsLimit) {
  PrintedLength printed(SiteOf().course);
  EXPECT_TRUE(printed.fits());
  LessonParts parts;
  parts.printed.size = kMostPrinted - 1;
  parts.printed_answers.size = 1;
  printed.add(parts);
  EXPECT_TRUE(printed.fits());
  parts.printed.size = 0;
  printed.add(parts);
  EXPECT_FALSE(printed.fits());
}

TEST(PrintedLength, CountsNoDraftsAndCardsToo) {
  SiteOf site;
  Lesson& outline = site.course.lessons[0];
  outline.kept = Lesson::Kept::outline;
  outline.length = kMostPrinted;
  EXPECT_FALSE(PrintedLength(site.course).fits());
  outline.front.draft = true;
  EXPECT_TRUE(PrintedLength(site.course).fits());
}

}  // namespace
}  // namespace mjcourse
