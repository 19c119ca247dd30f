#include "lesson/syntax/heading_id.h"

#include <gtest/gtest.h>

#include "reading_of.h"

namespace mjcourse {
namespace {

TEST(HeadingId, IsMadeOfWords) {
  EXPECT_EQ(id_of_heading("Why four numbers?"), "why-four-numbers");
  EXPECT_EQ(id_of_heading("  C++ & `a_b`: 1.2 "), "c-ab-12");
  EXPECT_EQ(id_of_heading("Équations à résoudre, 运动学"), "équations-à-résoudre-运动学");
  EXPECT_EQ(id_of_heading("ΩΜΕΓΑ, Сила"), "ωμεγα-сила");
  EXPECT_EQ(id_of_heading("?!"), "section");
}

TEST(HeadingId, HasNoPunctuationInAnyScript) {
  EXPECT_EQ(id_of_heading("What’s “new” — or ‘old’…"), "whats-new-or-old");
  EXPECT_EQ(id_of_heading("l’été « à » 2010–2020"), "lété-à-2010-2020");
  EXPECT_EQ(id_of_heading("什么是“刚体”？（一）"), "什么是刚体一");
  EXPECT_EQ(id_of_heading("¿Qué es esto?"), "qué-es-esto");
}

TEST(HeadingId, IsThatOfWhatWasTyped) {
  const ReadingOf reading = reading_of("## What's \"new\" -- and...\n\n## What’s new\n");
  ASSERT_EQ(reading.lesson->headings.size(), 2u);
  EXPECT_EQ(reading.lesson->headings[0].id, "whats-new-and");
  EXPECT_EQ(reading.lesson->headings[1].id, "whats-new");
}

}  // namespace
}  // namespace mjcourse
