#include "base/nearest.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <iostream>

namespace mjcourse {
namespace {

const std::vector<std::string> kFields{"qpos", "qvel", "xfrc_applied", "time"};

TEST(Nearest, FindsTheNameThatWasMeant) {
  EXPECT_EQ(nearest("qpso", kFields), "qpos");  // two letters swapped
  EXPECT_EQ(nearest("qpo", kFields), "qpos");   // one left out
  EXPECT_EQ(nearest("xfrc_aplied", kFields), "xfrc_applied");
  EXPECT_EQ(nearest("qvel", kFields), "qvel");
}

TEST(Nearest, TakesTheFirstOfTwoThatAreEquallyNear) {
  EXPECT_EQ(nearest("bat", {"cat", "hat"}), "cat");
}

TEST(Nearest, GivesALongNameAThirdOfItself) {
  EXPECT_EQ(nearest("generalised_cordinate", {"generalized_coordinates"}),
            "generalized_coordinates");
  EXPECT_EQ(nearest("abcdefghi", {"abcdefxyz"}), "abcdefxyz");  // three of nine
  EXPECT_EQ(nearest("abcdefghi", {"abcdewxyz"}), "");           // four of nine
}

TEST(Nearest, DoesNotMakeOneShortWordOutOfAnother) {
  EXPECT_EQ(nearest("ab", {"xy"}), "");
  EXPECT_EQ(nearest("a", {"b"}), "");
  EXPECT_EQ(nearest("", {"a", "ab"}), "");
}

TEST(Nearest, CountsCharacters) {
  EXPECT_EQ(nearest("Öffnüng", {"Offnung"}), "Offnung");  // two of seven
  EXPECT_EQ(nearest("一", {"二"}), "");
  EXPECT_EQ(nearest("\xFFqpos", {"qpos"}), "qpos");
}

TEST(Nearest, LooksForNoLongName) {
  const std::string name(80, 'a');
  EXPECT_EQ(nearest(name, {"b" + name}), "b" + name);
  EXPECT_EQ(nearest(name + "a", {"b" + name}), "");
  const std::string umlauts = std::string(78, 'a') + "äö";  // 80 of them
  EXPECT_EQ(nearest(umlauts, {"b" + umlauts}), "b" + umlauts);
}

// In a process of its own, which has nothing left for the other tests.
TEST(NearestDeathTest, TakesABillionStepsInARun) {
  const auto all_of_them = [] {
    // 6.4 million steps, of which 156 times are just less.
    const std::vector<std::string> long_names(1000, std::string(80, 'b'));
    const std::string name(80, 'a');
    for (int i = 0; i < 156; ++i) nearest(name, long_names);
    const std::string before = suggest("qpso", kFields);
    nearest(name, long_names);
    std::cerr << before << " " << suggest("qpso", kFields);
    std::exit(0);
  };
  EXPECT_EXIT(all_of_them(), testing::ExitedWithCode(0),
              "^did you mean `qpos`\\? known: qpos, qvel, xfrc_applied, time$");
}

TEST(Suggest, ListsNoLongName) {
  EXPECT_EQ(suggest("acceleration", {std::string(81, 'x'), "qpos"}), "known: qpos");
  EXPECT_EQ(suggest("acceleration", {std::string(81, 'x')}), "");
}

TEST(Suggest, AsksWhenSomethingIsNear) {
  EXPECT_EQ(suggest("qpso", kFields), "did you mean `qpos`?");
}

TEST(Suggest, ListsWhatThereIsWhenNothingIsNear) {
  EXPECT_EQ(suggest("acceleration", kFields), "known: qpos, qvel, xfrc_applied, time");
}

TEST(Suggest, ListsTheFirstDozen) {
  std::vector<std::string> many;
  for (char c = 'a'; c <= 'm'; ++c) many.emplace_back(1, c);
  EXPECT_EQ(suggest("acceleration", many), "known: a, b, c, d, e, f, g, h, i, j, k, l, …");
}

TEST(Suggest, SaysWhenThereIsNothingToChooseFrom) {
  EXPECT_EQ(suggest("anything", {}), "there is none yet");
}

}  // namespace
}  // namespace mjcourse
