#include "page/html/moved_html.h"

#include <gtest/gtest.h>

namespace mjcourse {
namespace {

TEST(MovedHtml, IdsAndWhatNamesThemGetThePrefix) {
  EXPECT_EQ(moved_html("<p id=\"a\">1 < 2</p><i aria-labelledby=\"a b\" for='c'></i>", {"x-"}),
            "<p id=\"x-a\">1 < 2</p><i aria-labelledby=\"x-a x-b\" for=\"x-c\"></i>");
  EXPECT_EQ(moved_html("<g clip-path=\"url(#c)\" fill=\"var(--data-1)\"/>", {"x-"}),
            "<g clip-path=\"url(#x-c)\" fill=\"var(--data-1)\"/>");
}

TEST(MovedHtml, EachAddressIsAskedFor) {
  HtmlMove move{"x-"};
  EXPECT_EQ(moved_html("<a href=\"#a\">", move), "<a href=\"#a\">");
  move.address = [](std::string_view address) { return "to/" + std::string(address); };
  EXPECT_EQ(moved_html("<a href=\"a\" title=\"b\"><img src=\"c\">", move),
            "<a href=\"to/a\" title=\"b\"><img src=\"to/c\">");
}

TEST(MovedHtml, HeadingsGoDown) {
  HtmlMove move{""};
  move.deeper = true;
  EXPECT_EQ(moved_html("<h2 id=\"a\">b</h2><h6>c</h6><hr><header></header>", move),
            "<h3 id=\"a\">b</h3><h6>c</h6><hr><header></header>");
}

TEST(MovedHtml, OnPaperNothingWaits) {
  HtmlMove move{""};
  move.still = true;
  EXPECT_EQ(moved_html("<sim-lab class=\"lab\" data-module=\"m.js\"><img loading=\"lazy\">", move),
            "<sim-lab class=\"lab\"><img>");
  EXPECT_EQ(
      moved_html("<figure class=\"example\" data-program=\"a.cpp\" data-code=\"p.js\">", move),
      "<figure class=\"example\">");
}

}  // namespace
}  // namespace mjcourse
