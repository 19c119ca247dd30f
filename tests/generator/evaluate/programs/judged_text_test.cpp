#include "evaluate/programs/judged_text.h"

#include <gtest/gtest.h>

namespace mjcourse {
namespace {

TEST(JudgedText, LeavesOutWhatAHandInIsNotToKnow) {
  EXPECT_EQ(tell_findings({"judge", 1}),
            "#undef expect\n"
            "#define expect(...) expect(::judge::Call{}, __VA_ARGS__)\n"
            "#undef expect_near\n"
            "#define expect_near(value, expected, tolerance, ...) "
            "expect_near(::judge::Call{}, value, __VA_ARGS__)\n"
            "#undef expect_alike\n"
            "#define expect_alike(...) expect_alike(::judge::Call{}, __VA_ARGS__)\n");
}

TEST(JudgedText, HasANameAMarkAndASeedThatNobodyKnowsBefore) {
  const JudgeKey one = JudgeKey::random(), other = JudgeKey::random();
  EXPECT_NE(one.name, other.name);
  EXPECT_NE(one.mark, other.mark);
  EXPECT_NE(one.seed, other.seed);
  EXPECT_FALSE(one.is_kept);
  EXPECT_TRUE(reporting_checks(one).starts_with("#define MJCOURSE_JUDGE " + one.name + "\n"));
}

}  // namespace
}  // namespace mjcourse
