#include "evaluate/scenes/plot.h"

#include <gtest/gtest.h>

namespace mjcourse {
namespace {

bool is_plain(const std::string& svg) {
  return are_plain({{svg, 10, 10}, std::nullopt}, "plot-1") &&
         are_plain({{"", 1, 1}, {{svg, 10, 10}}}, "plot-1");
}

// A drawing stands in the page itself, where a browser reads it as HTML.
TEST(Plot, HoldsWhatDrawsAlone) {
  EXPECT_TRUE(
      is_plain(R"x(<g transform="translate(1,2)"><path d="M0,0L1,1" fill="var(--data-1)"/></g>)x"));
  EXPECT_TRUE(is_plain(
      R"x(<defs><clipPath id="plot-1-p"><rect width="1"/></clipPath></defs><g clip-path="url(#plot-1-p)"/>)x"));
  EXPECT_TRUE(is_plain("<text x=\"1\">a &lt; b<tspan dy=\"2\">3</tspan></text>"));
  EXPECT_FALSE(is_plain("<script>alert(1)</script>"));
  EXPECT_FALSE(is_plain("</svg><script>alert(1)</script><svg>"));
  EXPECT_FALSE(is_plain("<g onclick=\"alert(1)\"/>"));
  EXPECT_FALSE(is_plain("<image href=\"https://a.example/x.png\"/>"));
  EXPECT_FALSE(is_plain("<foreignObject><b/></foreignObject>"));
  EXPECT_FALSE(is_plain("<g style=\"fill: url(https://a.example)\"/>"));
  EXPECT_FALSE(is_plain("<desc><![CDATA[ > <script>alert(1)</script> ]]></desc>"));
  EXPECT_FALSE(is_plain("<text><![CDATA[ > <script>alert(1)</script> ]]></text>"));
  EXPECT_FALSE(is_plain("<!-- > <script>alert(1)</script> -->"));
  EXPECT_FALSE(is_plain("<style>svg { }</style>"));
  EXPECT_FALSE(is_plain("<title>a</title>"));
  EXPECT_FALSE(is_plain("<p>a</p>"));
  EXPECT_FALSE(is_plain("<g"));
}

// In XML these are text, in HTML brackets: an address that only the browser would see.
TEST(Plot, HoldsNoCharacterThatOnlyHtmlNames) {
  EXPECT_TRUE(
      is_plain("<text x=\"1\" font-family=\"a&#xA;&quot;b&quot;\">a &gt; b &amp; c</text>"));
  for (const char* bracket : {"&lpar;", "&#40", "&#x28", "&#40;", "&lpar", "&", "&amp"}) {
    const std::string address = std::string("url") + bracket + "https://a.example/x.svg#y)";
    EXPECT_FALSE(is_plain("<g fill=\"" + address + "\"/>")) << bracket;
    EXPECT_FALSE(is_plain("<text>" + address + "</text>")) << bracket;
  }
  EXPECT_FALSE(is_plain("<text>&amp"));
}

// By which the page's scripts and styles would take it for a part of theirs.
TEST(Plot, HasNoNamesButItsOwn) {
  EXPECT_TRUE(is_plain("<tspan class=\"power\" dy=\"-0.4em\">3</tspan>"));
  for (const char* name : {"id=\"search\"", "id=\"plot-10-x\"", "class=\"lab\"", "data-lab=\"x\"",
                           "aria-label=\"x\"", "role=\"button\""}) {
    EXPECT_FALSE(is_plain("<g><path " + std::string(name) + " d=\"M0,0\"/></g>")) << name;
  }
}

}  // namespace
}  // namespace mjcourse
