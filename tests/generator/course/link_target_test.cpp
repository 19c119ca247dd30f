#include "course/link_target.h"

#include <gtest/gtest.h>

#include "course/course_of.h"

namespace mjcourse {
namespace {

TEST(Links, LeadToLessonsHeadingsAndTheWeb) {
  EXPECT_EQ(course_of("## One\n[a](1.2) [b](1.2#two) [c](#one) [d](https://a.example/#x) "
                      "[e](mailto:a@b.example)\n"
                      "[f](HTTPS://A.EXAMPLE) [g](Http://a.example) [h](MAILTO:a@b.example)\n",
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
  cure: a link leads to a lesson (`1.3`, `1.3#heading`), to a heading of its own page (`#heading`), to a model (`model:NAME`), to a MuJoCo name (`api:mj_step`) or to the web (`https://…`)
)");
}

TEST(Links, InAngleBracketsMayBeMeantAsText) {
  EXPECT_EQ(course_of("A vector<std::string>, a map<std::string>, [no]().\n", "").mistakes(),
            R"(content/1-a/1.1-x.md:4:10: error: `std::string` leads nowhere [E-link-dead]
  4 | A vector<std::string>, a map<std::string>, [no]().
    |          ^~~~~~~~~~~
  cure: what stands in `<…>` is a link; as text, write it as code, `` `<std::string>` ``, or `\<std::string>`
content/1-a/1.1-x.md:4:30: error: `std::string` leads nowhere [E-link-dead]
  4 | A vector<std::string>, a map<std::string>, [no]().
    |                              ^~~~~~~~~~~
  cure: what stands in `<…>` is a link; as text, write it as code, `` `<std::string>` ``, or `\<std::string>`
content/1-a/1.1-x.md:4:47: error: this link has no address [E-link-dead]
  4 | A vector<std::string>, a map<std::string>, [no]().
    |                                               ^
  cure: a link leads to a lesson (`1.3`, `1.3#heading`), to a heading of its own page (`#heading`), to a model (`model:NAME`), to a MuJoCo name (`api:mj_step`) or to the web (`https://…`)
)");
  EXPECT_EQ(course_of("<me@a.example> <https://a.example/>, https://a.example/\n", "").mistakes(),
            "");
}

// An address that acts leads nowhere, however it is written.
TEST(Links, DoNotAct) {
  for (const std::string link :
       {"[a](javascript:alert(1))", "[a](JaVaScRiPt:alert(1))",
        "[a](java&#115;cript&colon;alert(1))", "[a](<java\tscript:alert(1)>)",
        "[a](\\javascript:alert(1))", "[a](vbscript:x)", "[a](data:text/html,x)",
        "[a](data:text/html;base64,eA==)", "[a](//a.example/)", "[a](file:///etc/passwd)",
        "[a](blob:x)", "<javascript:alert(1)>", "[a][b]\n\n[b]: javascript:x",
        "> [!note] [a](javascript:x)\n>\n> b", "| [a](javascript:x) |\n|---|",
        "[![b](b.png)](javascript:x)"}) {
    const std::string mistakes = course_of(link + "\n", "").mistakes();
    EXPECT_NE(mistakes.find("leads nowhere [E-link-dead]"), mistakes.npos) << link << mistakes;
  }
  const std::string without = course_of("[a]()\n", "").mistakes();
  EXPECT_NE(without.find("this link has no address [E-link-dead]"), without.npos) << without;
  for (const std::string picture : {"![a](javascript:x)", "![a](data:image/svg+xml,x)"}) {
    const std::string mistakes = course_of(picture + "\n", "").mistakes();
    EXPECT_NE(mistakes.find("and not at an address on the web [E-image-place]"), mistakes.npos)
        << mistakes;
  }
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

TEST(Links, LeadToPagesOfModelsAndOfMujocosNames) {
  const CourseOf read({{"content/course.yaml", kTwo},
                       {"models/zoo.xml", "<mujoco/>"},
                       {"content/1-a/1.1-x.md", lesson("[a](model:zoo) [b](model:zo)\n")},
                       {"content/1-a/1.2-y.md", lesson("[c](api:mjModel.nq)\n")}});
  EXPECT_EQ(read.mistakes(),
            R"(content/1-a/1.1-x.md:4:20: error: there is no model `zo` in models/ [E-model-unknown]
  4 | [a](model:zoo) [b](model:zo)
    |                    ^~~~~~~~
  cure: did you mean `zoo`?
)");
  const auto zoo = resolve_link(*read.course, read.course->lessons[0], "model:zoo");
  EXPECT_EQ(zoo.value().page + "#" + zoo.value().anchor, "models/zoo.html#");
  const auto nq = resolve_link(*read.course, read.course->lessons[0], "api:mjModel.nq");
  EXPECT_EQ(nq.value().page + "#" + nq.value().anchor, "api.html#mjModel-nq");
}

TEST(Terms, MustBeInTheGlossary) {
  const CourseOf read({{"content/course.yaml", kTwo},
                       {"content/glossary.md", lesson("## Free joint\n\nIt.\n\n## Ödem\n\nIt.\n")},
                       {"content/1-a/1.1-x.md", lesson("[[FREE JOINT]] [[ödem]]\n")},
                       {"content/1-a/1.2-y.md", lesson("[[fre jiont]]\n")}});
  EXPECT_EQ(
      read.mistakes(),
      R"(content/1-a/1.2-y.md:4:3: error: the glossary has no term `fre jiont` [E-term-unknown]
  4 | [[fre jiont]]
    |   ^~~~~~~~~
  cure: did you mean `Free joint`?
)");
}

// Of a glossary that cannot be read nobody knows the terms: one mistake is not made many.
TEST(Terms, AreNotLookedForInABrokenGlossary) {
  const CourseOf read({{"content/course.yaml", kTwo},
                       {"content/glossary.md", "## Free joint\n"},
                       {"content/1-a/1.1-x.md", lesson("[[free joint]]\n")},
                       {"content/1-a/1.2-y.md", lesson("")}});
  ASSERT_EQ(read.diagnostics.size(), 1U);
  EXPECT_EQ(read.diagnostics[0].id, "E-front-matter");
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
