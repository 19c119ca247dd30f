#include "report/changed_words.h"

#include <gtest/gtest.h>

namespace mjcourse {
namespace {

TEST(ChangedWords, AreMarkedInBothLines) {
  const ChangedWords words = changed_words("nq = 7, nv = 6", "nq = 8, nv = 6 now");
  EXPECT_EQ(words.gone, "     ^~");
  EXPECT_EQ(words.come, "     ^~        ^~~");
  EXPECT_DOUBLE_EQ(words.alike, 10.0 / 13);
}

TEST(ChangedWords, OfTheSameLineAreNone) {
  const ChangedWords words = changed_words("a  b", "a b");
  EXPECT_EQ(words.gone + words.come, "");
  EXPECT_DOUBLE_EQ(words.alike, 1);
}

TEST(ChangedWords, OfLinesWithNothingInCommonAreAll) {
  const ChangedWords words = changed_words("ab c", "def");
  EXPECT_EQ(words.gone, "^~ ^");
  EXPECT_EQ(words.come, "^~~");
  EXPECT_DOUBLE_EQ(words.alike, 0);
}

// What is longest in common is kept: one word that moved is two that are marked.
TEST(ChangedWords, AreAsFewAsCanBe) {
  const ChangedWords words = changed_words("one two three four", "four one two three");
  EXPECT_EQ(words.gone, "              ^~~~");
  EXPECT_EQ(words.come, "^~~~");
}

TEST(ChangedWords, StandBelowTheirCharacters) {
  const ChangedWords words = changed_words("\töä…  x y", "\töä…  é𝒏 y");
  EXPECT_EQ(words.gone, "\t     ^");
  EXPECT_EQ(words.come, "\t     ^~");
}

TEST(ChangedWords, AreNotLookedForInEmptyOrVeryLongLines) {
  std::string most, more;
  for (int i = 0; i < 200; ++i) most += "x ";
  more = most + "x";
  EXPECT_DOUBLE_EQ(changed_words(most, most).alike, 1);
  for (const auto& [before, after] :
       {std::pair(most, more), std::pair(more, most), std::pair(std::string(), most)}) {
    const ChangedWords words = changed_words(before, after);
    EXPECT_DOUBLE_EQ(words.alike, 0);
    EXPECT_EQ(words.gone + words.come, "");
  }
}

}  // namespace
}  // namespace mjcourse
