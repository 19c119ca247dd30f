#include "course/uses.h"

#include <gtest/gtest.h>

#include "course/course_of.h"

namespace mjcourse {
namespace {

std::string listed(const std::vector<Use>& uses) {
  std::string text;
  for (const Use& use : uses) {
    text += use.page->slug + (use.section != nullptr ? "#" + use.section->id : "") + "\n";
  }
  return text;
}

CourseOf course_with_glossary(const std::string& x, const std::string& y,
                              const std::string& front = "") {
  return CourseOf(
      {{"content/course.yaml", kTwo},
       {"content/glossary.md", lesson("## Hinge\n\nSee [it](api:mj_step), [[hinge]].\n")},
       {"content/1-a/1.1-x.md", lesson(x)},
       {"content/1-a/1.2-y.md", lesson(y, front)}});
}

TEST(Uses, AreTheSectionsThatSpeakOfIt) {
  const CourseOf read = course_with_glossary(
      "[[hinge]]\n\n## One\n\n[[Hinge]] [[hinge]]\n\n## Two\n\n```io\nINPUT: [[hinge|a]]\n```\n",
      "## Three\n\n[a](api:mj_step) [b](api:mj_forward)\n");
  EXPECT_EQ(read.mistakes(), "");
  EXPECT_EQ(listed(uses_of_term(*read.course, "hinge")), "1.1-x\n1.1-x#one\n1.1-x#two\n");
  EXPECT_EQ(listed(uses_of_link(*read.course, "api:mj_step")), "1.2-y#three\nglossary#hinge\n");
}

TEST(Uses, OfAModelAreWhateverShowsIt) {
  const CourseOf read(
      {{"content/course.yaml", kTwo},
       {"models/arm.xml", ""},
       {"content/1-a/1.1-x.md",
        lesson("## One\n\n```cpp snippet model=arm\nint x;\n```\n\n## Two\n\n[it](model:arm)\n\n## "
               "Three\n\n```xml model=arm\n<a/>\n```\n")},
       {"content/1-a/1.2-y.md", lesson("```xml mjcf\n<mujoco/>\n```\n")}});
  EXPECT_EQ(read.mistakes(), "");
  EXPECT_EQ(listed(uses_of_model(*read.course, "arm")), "1.1-x#one\n1.1-x#two\n1.1-x#three\n");
}

TEST(Uses, AreNotInDrafts) {
  const CourseOf read = course_with_glossary("", "[[hinge]] [a](api:mj_step)\n", "draft: true\n");
  EXPECT_EQ(listed(uses_of_term(*read.course, "hinge")), "");
  EXPECT_EQ(listed(uses_of_link(*read.course, "api:mj_step")), "glossary#hinge\n");
}

}  // namespace
}  // namespace mjcourse
