#include "course/language.h"

#include <gtest/gtest.h>

namespace mjcourse {
namespace {

TEST(Language, IsATag) {
  for (const char* tag : {"de", "en-GB", "zh-Hans", "zh-Hant-TW", "es-419", "ca-valencia",
                          "de-1996", "zh-yue", "DE-ch", "nds", "en-u-co-phonebk", "de-x-own"}) {
    EXPECT_EQ(cure_of_language(tag), std::nullopt) << tag;
  }
}

TEST(Language, HasACureWhereItIsNone) {
  const std::string other = "write a tag of BCP 47, as `de`, `en-GB` or `zh-Hans`";
  EXPECT_EQ(cure_of_language("de_AT"), "did you mean `de-AT`?");
  EXPECT_EQ(cure_of_language("de_AT.UTF-8"), "did you mean `de-AT`?");
  for (const char* tag :
       {"english", "d", "de-", "de--AT", "de-A", "de AT", "-de", "\xC3\xBC", "x"}) {
    EXPECT_EQ(cure_of_language(tag), other) << tag;
  }
}

TEST(Language, RunsFromRightToLeftByItsScript) {
  for (const char* tag : {"ar", "he-IL", "fa", "ur", "AR-eg", "pa-Arab", "ks-Arab-IN", "ckb"}) {
    EXPECT_TRUE(is_right_to_left(tag)) << tag;
  }
  for (const char* tag : {"en", "de-AT", "ar-Latn", "az", "zh", "pa", "arn"}) {
    EXPECT_FALSE(is_right_to_left(tag)) << tag;
  }
}

}  // namespace
}  // namespace mjcourse
