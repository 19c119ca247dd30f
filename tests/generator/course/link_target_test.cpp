#include "course/link_target.h"

#include <gtest/gtest.h>

#include "course/course_of.h"

namespace mjcourse {
namespace {

TEST(Links, LeadToLessonsHeadingsAndTheWeb) {
  EXPECT_EQ(course_of("## One\n[a](1.2) [b](1.2#two) [c](#one) [d](https://a.example/#x) "
                      "[e](mailto:a@b.example)\n",
                      "## Two\n")
                .mistakes(),
            "");
}

TEST(Links, MustLeadToALessonThatIsThere) {
  EXPECT_EQ(
      course_of("See [it](1.3).\n", "").mistakes(),
      R"(content/1-a/1.1-x.md:4:10: error: there is no lesson `1.3` in this course [E-link-dead]
  4 | See [it](1.3).
    |          ^~~
  cure: did you mean `1.2`?
)");
  EXPECT_EQ(course_of("See [it](other.md).\n", "").mistakes(),
            R"(content/1-a/1.1-x.md:4:10: error: `other.md` leads nowhere [E-link-dead]
  4 | See [it](other.md).
    |          ^~~~~~~~
  cure: a link leads to a lesson (`1.3`, `1.3#heading`), to a heading of its own page (`#heading`) or to the web (`https://…`)
)");
}

TEST(Links, MustNotLeadOutOfTheSiteIntoADraft) {
  EXPECT_EQ(
      course_of("", "See [it](1.1).\n", "draft: true\n").mistakes(),
      R"(content/1-a/1.2-y.md:4:10: error: lesson 1.1 is a draft, and not in the site [E-link-dead]
  4 | See [it](1.1).
    |          ^~~
  cure: link to it when its `draft` is gone
)");
  EXPECT_EQ(course_of("See [it](1.2) and [me](1.1).\n", "", "draft: true\n").mistakes(), "");
}

TEST(Links, MustLeadToAHeadingThatIsThere) {
  EXPECT_EQ(course_of("See [it](1.2#tow).\n", "## Two\n## Three\n").mistakes(),
            R"(content/1-a/1.1-x.md:4:10: error: lesson 1.2 has no heading `#tow` [E-link-anchor]
  4 | See [it](1.2#tow).
    |          ^~~~~~~
  cure: did you mean `two`?
)");
  EXPECT_EQ(course_of("See [it](#one).\n", "## One\n").mistakes(),
            R"(content/1-a/1.1-x.md:4:10: error: lesson 1.1 has no heading `#one` [E-link-anchor]
  4 | See [it](#one).
    |          ^~~~
  cure: there is none yet
)");
}

TEST(Links, AreFoundInsideBlocksToo) {
  const CourseOf found = course_of(
      "```quiz\n{\"id\": \"q\", \"questions\": [{\"kind\": \"numeric\", \"answer\": 1,\n"
      "  \"q\": \"As in [1.2](9.9)?\"}]}\n```\n",
      "");
  EXPECT_EQ(
      found.mistakes(),
      R"(content/1-a/1.1-x.md:6:21: error: there is no lesson `9.9` in this course [E-link-dead]
  6 |   "q": "As in [1.2](9.9)?"}]}
    |                     ^~~
  cure: did you mean `1.2`?
)");
}

TEST(Links, SayWhatThisVersionCannotDoYet) {
  EXPECT_EQ(
      course_of("[a](model:zoo)\n", "").mistakes(),
      R"(content/1-a/1.1-x.md:4:5: error: links to `model:` belong to the lesson language, but this version of mjcourse cannot do them yet [E-not-yet]
  4 | [a](model:zoo)
    |     ^~~~~~~~~
  cure: write the name as code for now
)");
  EXPECT_EQ(course_of("[a](api:mj_step)\n", "").diagnostics.at(0).id, "E-not-yet");
}

TEST(Prerequisites, MustBeLessonsOfTheCourse) {
  EXPECT_EQ(course_of("", "", "prerequisites: [1.2]\n").mistakes(), "");
  EXPECT_EQ(
      course_of("", "", "prerequisites: [1.2, 0.1]\n").mistakes(),
      R"(content/1-a/1.1-x.md:3:22: error: there is no lesson `0.1` in this course [E-link-dead]
  3 | prerequisites: [1.2, 0.1]
    |                      ^~~
  cure: did you mean `1.2`?
)");
}

}  // namespace
}  // namespace mjcourse
