#include "course/yaml_tree.h"

#include <gtest/gtest.h>

namespace mjcourse {
namespace {

bool same(const std::string& a, const std::string& b) {
  return same_tree(YAML::Load(a), YAML::Load(b));
}

TEST(YamlTree, IsTheSameInAnyLayout) {
  EXPECT_TRUE(same("a: [1, {b: c}]\n", "# why\n'a':\n  - 1\n  - b: \"c\"\n"));
  EXPECT_TRUE(same("", "# nothing\n"));
}

TEST(YamlTree, IsAnotherWithOtherValues) {
  EXPECT_FALSE(same("a: 1", "a: 2"));
  EXPECT_FALSE(same("a: 1", "b: 1"));
  EXPECT_FALSE(same("[1, 2]", "[2, 1]"));
  EXPECT_FALSE(same("{a: 1, b: 2}", "{b: 2, a: 1}"));
  EXPECT_FALSE(same("[1]", "[1, 1]"));
  EXPECT_FALSE(same("a: [b]", "a: b"));
  EXPECT_FALSE(same("a: {b: [c]}", "a: {b: [d]}"));
  EXPECT_FALSE(same("a:", "a: ''"));
}

TEST(YamlTree, HasAliasesWhereAPartStandsForAnother) {
  EXPECT_TRUE(has_aliases("a: &x [1]\nb: *x\n"));
  EXPECT_FALSE(has_aliases("a: &x [1]\nb: '*x'\n"));
  EXPECT_FALSE(has_aliases(""));
}

}  // namespace
}  // namespace mjcourse
