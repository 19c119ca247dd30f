#include "page/html/placeholder.h"

#include <gtest/gtest.h>

namespace mjcourse {
namespace {

TEST(Placeholder, GivesWayToItsText) {
  std::string html = "<p>" + placeholder("body") + placeholder("end") + "</p>";
  fill_placeholder(html, "end", "!");
  fill_placeholder(html, "body", "body");
  EXPECT_EQ(html, "<p>body!</p>");
}

}  // namespace
}  // namespace mjcourse
