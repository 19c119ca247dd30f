#include "cli/letter_names.h"

#include <gtest/gtest.h>

namespace mjcourse {
namespace {

using Names = std::vector<std::string>;

TEST(LetterNames, AreThoseOfTheStudents) {
  EXPECT_EQ(letter_names({"ann", "eva maria", "-dash"}),
            (Names{"ann.md", "eva maria.md", "-dash.md"}));
}

TEST(LetterNames, AreSeenInAListing) {
  EXPECT_EQ(letter_names({"./Ann", "./../w/ann", ".x", "..y", "/in/./bob/", "."}),
            (Names{"Ann.md", "w_ann.md", "_x.md", "_.y.md", "in_bob.md", "_.md"}));
}

TEST(LetterNames, AreNoTwoTheSameOnAnySystem) {
  EXPECT_EQ(letter_names({"ann", "Ann", "./ann", "ann-2", "ren\u00e9", "RENe\u0301", "rene"}),
            (Names{"ann.md", "Ann-2.md", "ann-3.md", "ann-2-2.md", "ren\u00e9.md",
                   "RENe\u0301-2.md", "rene.md"}));
  const std::string longest(300, 'x');
  const Names names = letter_names({longest + "a", longest + "b"});
  EXPECT_LT(names[0].size(), 230u);
  EXPECT_NE(names[0], names[1]);
}

}  // namespace
}  // namespace mjcourse
