#include "evaluate/scenes/excerpt_match.h"

#include <gtest/gtest.h>

#include <string>

namespace mjcourse {
namespace {

constexpr const char* kWhole = "<a>\n  <b/>\n\n  <c x=\"1\"/>\n  <d/>\n  <b/>\n  <e/>\n</a>\n";

// "3 5": line 3 of the excerpt against line 5 of the whole; "" for an excerpt.
std::string mismatch(const std::string& excerpt) {
  const auto found = find_excerpt_mismatch(excerpt, kWhole);
  return found ? std::to_string(found->excerpt) + " " + std::to_string(found->whole) : "";
}

TEST(ExcerptMatch, TakesLinesThatStandTogether) {
  EXPECT_EQ(mismatch("<b/>\n<c x=\"1\"/>\n"), "");
  EXPECT_EQ(mismatch("      <b/>\n\n\n  <e/>"), "");
  EXPECT_EQ(mismatch(kWhole), "");
}

TEST(ExcerptMatch, SkipsLinesWhereItIsToldTo) {
  EXPECT_EQ(mismatch("<a>\n  …\n  <d/>\n"), "");
  EXPECT_EQ(mismatch("<a>\n  <!-- … -->\n</a>\n"), "");
  EXPECT_EQ(mismatch("<a>\n  <!-- … two more -->\n  <e/>\n"), "");
  EXPECT_EQ(mismatch("…\n<e/>\n…\n"), "");
}

TEST(ExcerptMatch, FindsTheNearestPlace) {
  EXPECT_EQ(mismatch("<b/>\n<c x=\"2\"/>\n<d/>\n"), "2 4");
  EXPECT_EQ(mismatch("<c x=\"2\"/>\n<d/>\n"), "1 4");
  EXPECT_EQ(mismatch("<c x=\"2\"/>\n"), "1 4");
  EXPECT_EQ(mismatch("<nothing like=\"it\"/>\n"), "1 0");
}

TEST(ExcerptMatch, MissesALineThatWasLeftOutSilently) {
  EXPECT_EQ(mismatch("<a>\n<c x=\"1\"/>\n"), "2 2");
}

TEST(ExcerptMatch, KeepsTheOrder) {
  EXPECT_EQ(mismatch("<e/>\n…\n<c x=\"1\"/>\n"), "3 0");
  EXPECT_EQ(mismatch("<e/>\n</a>\n<b/>\n"), "3 0");
}

}  // namespace
}  // namespace mjcourse
