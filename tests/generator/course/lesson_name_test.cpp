#include "course/lesson_name.h"

#include <gtest/gtest.h>

namespace mjcourse {
namespace {

TEST(LessonName, HasItsParts) {
  const LessonName name = read_lesson_name("12.3-rigid-bodies").value();
  EXPECT_EQ(name.level, "12");
  EXPECT_EQ(name.place, 3);
  EXPECT_EQ(name.slug, "rigid-bodies");
  EXPECT_EQ(name.number(), "12.3");
  EXPECT_EQ(name.text(), "12.3-rigid-bodies");
  EXPECT_EQ(read_lesson_name("A.1-x").value().level, "A");
  for (const char* none : {"rigid", "1-rigid", "a.1-x", "1.1", "1.1-", "1.1-a/b"}) {
    EXPECT_FALSE(read_lesson_name(none)) << none;
  }
}

TEST(LessonName, IsMadeOfATitleAndBack) {
  EXPECT_EQ(slug_of("Rigid bodies, 2"), "rigid-bodies-2");
  EXPECT_EQ(slug_of("Newton's laws!"), "newtons-laws");
  EXPECT_EQ(slug_of("Newton’s laws – “first” steps…"), "newtons-laws-first-steps");
  EXPECT_EQ(slug_of(" 'Tis_a/B.c "), "tis-a-b-c");
  EXPECT_EQ(slug_of("Kräfte"), "");
  EXPECT_EQ(slug_of("Ärger"), "");
  EXPECT_EQ(slug_of("r²"), "");
  EXPECT_EQ(slug_of("caf\xE9"), "");
  EXPECT_EQ(slug_of("…"), "");
  EXPECT_EQ(title_of("rigid-bodies-2"), "Rigid bodies 2");
  EXPECT_EQ(title_of(""), "");
}

}  // namespace
}  // namespace mjcourse
