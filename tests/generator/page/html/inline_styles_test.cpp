#include "page/html/inline_styles.h"

#include <gtest/gtest.h>

namespace mjcourse {
namespace {

TEST(InlineStyles, AStyleBecomesAClass) {
  InlineStyles styles;
  EXPECT_EQ(styles.take("<p>a <span style=\"top:-3em;\">b</span></p>"),
            "<p>a <span class=\"s0\">b</span></p>");
  EXPECT_EQ(styles.sheet(), ".s0{top:-3em;}\n");
}

TEST(InlineStyles, EqualStylesShareOneAndOtherClassesStay) {
  InlineStyles styles;
  EXPECT_EQ(styles.take("<b class=\"x y\" style=\"top:0\" id='i'></b><i style=\"top:0\"/>"),
            "<b class=\"x y s0\" id='i'></b><i class=\"s0\"/>");
  EXPECT_EQ(styles.take("<u style='left:0'>"), "<u class=\"s1\">");
  EXPECT_EQ(styles.sheet(), ".s0{top:0}\n.s1{left:0}\n");
}

TEST(InlineStyles, ALargerThanSignInQuotesEndsNoTag) {
  InlineStyles styles;
  EXPECT_EQ(styles.take("<a title=\"x > y\" style=\"content:&quot;&amp;&quot;\">z</a>"),
            "<a class=\"s0\" title=\"x > y\">z</a>");
  EXPECT_EQ(styles.sheet(), ".s0{content:\"&\"}\n");
}

TEST(InlineStyles, WhatHasNoStyleStaysToTheByte) {
  const std::string html =
      "<!DOCTYPE html>\n<p  data-style=\"a\" hidden>1 &lt; 2 < 3</p><!-- <3 --><br/>style=\"x\" <";
  InlineStyles styles;
  EXPECT_EQ(styles.take(html), html);
  EXPECT_EQ(styles.sheet(), "");
}

TEST(InlineStyles, ATagThatNeverEndsIsNoTrouble) {
  InlineStyles styles;
  EXPECT_EQ(styles.take("<p style=\"a"), "<p class=\"s0\"");
  EXPECT_EQ(styles.take("<p title='"), "<p title='");
}

}  // namespace
}  // namespace mjcourse
