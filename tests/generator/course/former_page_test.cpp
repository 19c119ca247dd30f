#include "course/former_page.h"

#include <gtest/gtest.h>

#include "course_of.h"

namespace mjcourse {
namespace {

// Each mistake: id, message.
std::string mistakes_of(const CourseOf& course) {
  std::string text;
  for (const Diagnostic& d : course.diagnostics) text += d.id + " " + d.message + "\n";
  return text;
}

std::string former(const std::string& written) {
  const CourseOf read = course_of("", "");
  return former_page(read.course->lessons[0], written).value_or("none");
}

TEST(FormerPage, StandsInTheLessonsFolderOrInAnother) {
  EXPECT_EQ(former("1.7-old"), "1-a/1.7-old.html");
  EXPECT_EQ(former("1.7-old.html"), "1-a/1.7-old.html");
  EXPECT_EQ(former("0-before/1.7-old"), "0-before/1.7-old.html");
  EXPECT_EQ(former("0-before/old_name.html"), "0-before/old_name.html");
}

TEST(FormerPage, IsNothingElse) {
  for (const char* written :
       {"",      "/",       "..",    "../x", "x/..",         "/x",          "x/",
        "a/b/c", ".hidden", "a b",   "x?y",  "x#y",          "\xC3\xBC",    "https://a.org",
        ".html", "con",     "nul/x", "x./y", "index.html/x", "search.js/x", "index.html.gz/x"}) {
    EXPECT_EQ(former(written), "none") << written;
  }
}

TEST(FormerPages, MayBeAnyNumberOfThem) {
  EXPECT_EQ(mistakes_of(course_of("", "", "formerly: [1.7-old, 1.8-older, 9-z/1.1-x]\n")), "");
}

TEST(FormerPages, AreWhereNoPageIs) {
  EXPECT_EQ(mistakes_of(course_of("", "", "formerly: [1.2-y, 1-a/1.1-x.html, 'a b']\n")),
            "E-formerly-taken lesson 1.2 is at 1-a/1.2-y.html\n"
            "E-formerly-taken 1-a/1.1-x.html is where this lesson is now\n"
            "E-formerly-path `a b` is not an address that a page here can have\n");
  const CourseOf with_model({{"content/course.yaml", kTwo},
                             {"content/1-a/1.1-x.md", lesson("", "formerly: [models/arm]\n")},
                             {"content/1-a/1.2-y.md", lesson("")},
                             {"models/arm.xml", "<mujoco/>"}});
  EXPECT_EQ(mistakes_of(with_model),
            "E-formerly-taken the page of a model is at models/arm.html\n");
}

TEST(FormerPages, AreOneLessonsEach) {
  const CourseOf read({{"content/course.yaml", kTwo},
                       {"content/1-a/1.1-x.md", lesson("", "formerly: [old, 1-a/old.html]\n")},
                       {"content/1-a/1.2-y.md", lesson("", "formerly: [1-a/old]\n")}});
  EXPECT_EQ(mistakes_of(read),
            "E-formerly-twice 1-a/old.html is listed here twice\n"
            "E-formerly-twice lesson 1.1 was at 1-a/old.html as well\n");
}

}  // namespace
}  // namespace mjcourse
