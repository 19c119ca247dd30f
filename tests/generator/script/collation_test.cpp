#include "script/collation.h"

#include <gtest/gtest.h>

#include "bundle.h"

namespace mjcourse {
namespace {

std::string sorted(const std::string& language, const std::vector<std::string>& texts) {
  std::string text;
  for (const std::size_t at : alphabetical(bundle("collate"), language, texts)) {
    text += texts[at] + " ";
  }
  return text;
}

TEST(Collation, IsThatOfADictionary) {
  EXPECT_EQ(sorted("en", {"zebra", "Äpfel", "apple", "Zoo", "b"}), "Äpfel apple b zebra Zoo ");
  EXPECT_EQ(sorted("sv", {"zebra", "ängel", "apple"}), "apple zebra ängel ");
  EXPECT_EQ(sorted("en", {"joint 10", "joint 9"}), "joint 9 joint 10 ");
}

TEST(Collation, TakesLanguagesThatAreNone) {
  EXPECT_EQ(sorted("", {"b", "A"}), "A b ");
  EXPECT_EQ(sorted("not a language", {"b", "A"}), "A b ");
}

}  // namespace
}  // namespace mjcourse
