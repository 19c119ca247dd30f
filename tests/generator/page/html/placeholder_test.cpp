#include "page/html/placeholder.h"

#include <gtest/gtest.h>

namespace mjcourse {
namespace {

TEST(Placeholder, GivesWayToItsText) {
  std::string html = "<p>" + placeholder("body") + placeholder("end") + "</p>";
  EXPECT_TRUE(fill_placeholder(html, "end", "!"));
  EXPECT_TRUE(fill_placeholder(html, "body", "body"));
  EXPECT_EQ(html, "<p>body!</p>");
}

TEST(Placeholder, IsThereOnce) {
  std::string html = placeholder("body") + placeholder("body");
  EXPECT_FALSE(fill_placeholder(html, "body", "x"));
  EXPECT_FALSE(fill_placeholder(html, "end", "x"));
  EXPECT_EQ(html, placeholder("body") + placeholder("body"));
}

}  // namespace
}  // namespace mjcourse
