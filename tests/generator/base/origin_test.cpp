#include "base/origin.h"

#include <gtest/gtest.h>

namespace mjcourse {
namespace {

const std::string kA(64, 'a'), kB(64, 'b');

Origin of_both(const Origin& one, const Origin& other) {
  Origin both = one;
  both.add(other);
  return both;
}

TEST(Origin, OfWhatIsMadeOfOthersIsThatOfAll) {
  const Origin made, none = Origin::unsigned_one(), a = Origin::signed_by(kA),
                     b = Origin::signed_by(kB);
  EXPECT_TRUE(of_both(made, made).is_made_here());
  EXPECT_EQ(of_both(made, a), a);
  EXPECT_EQ(of_both(a, a), a);
  EXPECT_EQ(of_both(a, b).text(), kA + "," + kB);
  for (const Origin& other : {made, a, b, none}) {
    EXPECT_EQ(of_both(none, other), none);
    EXPECT_EQ(of_both(other, none), none);
  }
}

TEST(Origin, IsAWord) {
  for (const std::string& text :
       {std::string("made"), std::string("unsigned"), kA, kA + "," + kB}) {
    ASSERT_TRUE(Origin::read(text)) << text;
    EXPECT_EQ(Origin::read(text)->text(), text);
  }
  for (const std::string& text :
       {std::string(), std::string("Made"), kA + ",", "," + kA, kA + kB, kA.substr(1), kA + ",made",
        std::string(64, 'g'), std::string("made\n")}) {
    EXPECT_FALSE(Origin::read(text)) << text;
  }
}

TEST(Trust, IsInEverybodyOrInKeys) {
  const Origin made, none = Origin::unsigned_one(), a = Origin::signed_by(kA),
                     both = of_both(a, Origin::signed_by(kB));
  const Trust all, in_a{.everybody = false, .keys = {kA}}, in_both{false, {kA, kB}}, in_none{false};
  for (const Trust& trust : {all, in_a, in_both, in_none}) EXPECT_TRUE(trust.believes(made));
  EXPECT_TRUE(all.believes(none));
  EXPECT_TRUE(all.believes(both));
  EXPECT_FALSE(all.vouches_for(none));
  EXPECT_FALSE(all.vouches_for(a));
  EXPECT_TRUE(all.vouches_for(made));
  EXPECT_FALSE(in_a.believes(none));
  EXPECT_TRUE(in_a.believes(a));
  EXPECT_FALSE(in_a.believes(both));
  EXPECT_TRUE(in_both.believes(both));
  EXPECT_FALSE(in_none.believes(a));
}

}  // namespace
}  // namespace mjcourse
