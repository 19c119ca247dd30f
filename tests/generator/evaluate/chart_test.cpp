#include "evaluate/chart.h"

#include <gtest/gtest.h>

namespace mjcourse {
namespace {

bool is_plain(const std::string& svg) {
  return are_plain({{svg, 10, 10}, std::nullopt}) && are_plain({{"", 1, 1}, {{svg, 10, 10}}});
}

// A drawing stands in the page itself, where a browser reads it as HTML.
TEST(Chart, HoldsWhatDrawsAlone) {
  EXPECT_TRUE(
      is_plain(R"x(<g transform="translate(1,2)"><path d="M0,0L1,1" fill="var(--data-1)"/></g>)x"));
  EXPECT_TRUE(is_plain(
      R"x(<defs><clipPath id="p"><rect width="1"/></clipPath></defs><g clip-path="url(#p)"/>)x"));
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

}  // namespace
}  // namespace mjcourse
