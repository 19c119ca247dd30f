#include "evaluate/programs/judged_text.h"

#include <gtest/gtest.h>

namespace mjcourse {
namespace {

TEST(JudgedText, LeavesOutWhatAHandInIsNotToKnow) {
  EXPECT_EQ(tell_findings({"judge", {}}),
            "#undef expect\n"
            "#define expect(...) expect(::judge::Call{}, __VA_ARGS__)\n"
            "#undef expect_near\n"
            "#define expect_near(value, expected, tolerance, ...) "
            "expect_near(::judge::Call{}, ::judge::like<decltype(expected)>(value), __VA_ARGS__)\n"
            "#undef expect_alike\n"
            "#define expect_alike(...) expect_alike(::judge::Call{}, __VA_ARGS__)\n");
}

TEST(JudgedText, HasANameAMarkAndASeedThatNobodyKnowsBefore) {
  const JudgeKey one = JudgeKey::random(), other = JudgeKey::random();
  EXPECT_NE(one.name, other.name);
  EXPECT_NE(one.mark.first, other.mark.first);
  EXPECT_NE(one.mark.second, other.mark.second);
  EXPECT_NE(one.seed, other.seed);
  EXPECT_FALSE(one.is_kept);
  EXPECT_TRUE(reporting_checks(one).starts_with("#define MJCOURSE_JUDGE " + one.name + "\n"));
}

TEST(JudgedText, FindsAgainWhatWasHandedIn) {
  const JudgeKey key{"judge", {}};
  EXPECT_EQ(marked_code(key, "  a;\n", 7, "a.cpp"),
            "#line 1 \"judge\"\n#line 7 \"a.cpp\"\n  a;\n#line 2 \"judge\"\n");
  EXPECT_EQ(find_marked_code(key, "x\n# 1 \"judge\"\n# 7 \"a.cpp\"\n b;\n# 2 \"judge\"\ny\n"),
            "# 7 \"a.cpp\"\n b;\n");
  EXPECT_EQ(find_marked_code(key, "# 1 \"judge\"\n"), std::nullopt);
  EXPECT_EQ(find_marked_code(key, "# 2 \"judge\"\n"), std::nullopt);
}

}  // namespace
}  // namespace mjcourse
