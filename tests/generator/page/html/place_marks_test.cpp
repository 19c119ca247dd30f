#include "page/html/place_marks.h"

#include <gtest/gtest.h>

#include "page/html/markdown_html.h"
#include "reading_of.h"

namespace mjcourse {
namespace {

// cmark does not know formulas.
const NodeWriter kPlain{
    [](cmark_node* node) { return cmark_node_get_type(node) == math_inline_type(); },
    [](cmark_node*, const std::string&) { return std::string("a formula"); }};

TEST(PlaceMarks, SayWhereEachPartStands) {
  const ReadingOf reading = reading_of("One.\n\nTwo,\nof two lines.\n\n- three\n");
  const Lesson& lesson = reading.lesson.value();
  const std::string plain = render_html(lesson.document.get(), kPlain);
  {
    const PlaceMarks marks(lesson, {});
    EXPECT_EQ(render_html(lesson.document.get(), kPlain),
              "<!--lines 4-4-->\n<p>One.</p>\n"
              "<!--lines 6-7-->\n<p>Two,\nof two lines.</p>\n"
              "<!--lines 9-9-->\n<ul>\n<li>three</li>\n</ul>\n");
  }
  EXPECT_EQ(render_html(lesson.document.get(), kPlain), plain);
}

TEST(PlaceMarks, SayWhatRuns) {
  const ReadingOf reading = reading_of("One.\n\nTwo: $x$.\n");
  const Lesson& lesson = reading.lesson.value();
  LessonResults results;
  results.open = {0};
  const PlaceMarks marks(lesson, results);
  const std::string html = render_html(lesson.document.get(), kPlain);
  EXPECT_EQ(html.find(" running-->"), html.rfind(" running-->"));
  EXPECT_LT(html.find("One."), html.find(" running-->"));
}

}  // namespace
}  // namespace mjcourse
