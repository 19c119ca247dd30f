#include "lsp/lesson_fences.h"

#include <gtest/gtest.h>

namespace mjcourse {
namespace {

std::string bodies_of(const SourceText& text) {
  std::string all;
  for (const LessonFence& fence : fences_of(text)) {
    all += fence.kind() + "{" + unquoted(text, fence.body) + "}";
  }
  return all;
}

TEST(LessonFences, AreFound) {
  EXPECT_EQ(bodies_of({"", "a\n```lab simlab\n{}\n```\nb\n~~~text\n```\n~~~\n"}),
            "lab{{}\n}text{```\n}");
}

TEST(LessonFences, MayBeQuoted) {
  EXPECT_EQ(bodies_of({"", "> ```quiz\n> {\n>   1\n> ```\n"}), "quiz{{\n1\n}");
}

TEST(LessonFences, MayStandInADemo) {
  EXPECT_EQ(bodies_of({"", "````demo\n```text\nx\n```\n````\n"}),
            "demo{```text\nx\n```\n}text{x\n}");
}

TEST(LessonFences, GoOnToTheEndWhereTheyAreNotClosed) {
  const SourceText text("", "```lab simlab\n{\n");
  EXPECT_EQ(bodies_of(text), "lab{{\n}");
  EXPECT_NE(fence_at(fences_of(text), 16), nullptr);
}

TEST(LessonFences, AreNoCodeSpans) {
  EXPECT_EQ(bodies_of({"", "```a``` and\n``\n"}), "");
}

TEST(LessonFences, TheInnermostIsAround) {
  const SourceText text("", "````demo\n```text\nx\n```\n````\n");
  const std::vector<LessonFence> fences = fences_of(text);
  EXPECT_EQ(fence_at(fences, 17)->kind(), "text");
  EXPECT_EQ(fence_at(fences, 3)->kind(), "demo");
  EXPECT_EQ(fence_at(fences, text.text().size()), nullptr);
}

}  // namespace
}  // namespace mjcourse
