#include "script/typeset.h"

#include <gtest/gtest.h>

#include "bundle.h"

namespace mjcourse {

class TypesetterTest : public testing::Test {
 protected:
  // "offset+length message | cure" of a formula that must not typeset.
  std::string error(const std::string& tex) {
    const auto html = typesetter_.typeset(tex, false);
    if (html) return "no error";
    const MathError& wrong = html.error();
    return std::to_string(wrong.offset) + "+" + std::to_string(wrong.length) + " " + wrong.message +
           " | " + wrong.cure;
  }

  Typesetter typesetter_{bundle("typeset"), {{"\\qpos", "\\mathbf{q}"}, {"\\bad", "x\\nope"}}};
};

TEST_F(TypesetterTest, GivesHtmlWithMathml) {
  EXPECT_EQ(
      typesetter_.typeset("q", false).value(),
      "<span class=\"katex\"><span class=\"katex-mathml\"><math "
      "xmlns=\"http://www.w3.org/1998/Math/MathML\"><semantics><mrow><mi>q</mi></mrow>"
      "<annotation encoding=\"application/x-tex\">q</annotation></semantics></math></span>"
      "<span class=\"katex-html\" aria-hidden=\"true\"><span class=\"base\"><span "
      "class=\"strut\" style=\"height:0.625em;vertical-align:-0.1944em;\"></span><span "
      "class=\"mord mathnormal\" style=\"margin-right:0.0359em;\">q</span></span></span></span>");
  EXPECT_EQ(typesetter_.typeset("q", true).value().substr(0, 28), "<span class=\"katex-display\">");
}

TEST_F(TypesetterTest, TypesetsTheFirstLesson) {
  for (const char* tex :
       {"\\mathbf{q} = (w, x, y, z) = \\left(\\cos\\tfrac{\\theta}{2},\\ "
        "\\sin\\tfrac{\\theta}{2}\\,\\hat{\\mathbf{n}}\\right)",
        "q_{t+h} = q_t + h\\,v_{t+h}", "\\boldsymbol{\\omega}",
        "\\mathbf{q}_{t+h} = \\mathbf{q}_t \\otimes \\exp\\!\\left(\\tfrac{h}{2}\\,(0, "
        "\\boldsymbol{\\omega})\\right), \\qquad \\exp\\!\\left(\\tfrac12 "
        "(0,\\boldsymbol\\phi)\\right) = \\left(\\cos\\tfrac{|\\boldsymbol\\phi|}{2},\\ "
        "\\sin\\tfrac{|\\boldsymbol\\phi|}{2}\\,\\tfrac{\\boldsymbol\\phi}{|\\boldsymbol\\phi|}"
        "\\right),",
        "\\boldsymbol\\omega = \\tfrac{1}{h}\\,\\log(\\mathbf{q}_1^{-1} \\otimes \\mathbf{q}_2)",
        "10^{-12}"}) {
    EXPECT_TRUE(typesetter_.typeset(tex, true)) << error(tex);
  }
}

TEST_F(TypesetterTest, KnowsTheCoursesMacros) {
  EXPECT_NE(typesetter_.typeset("\\qpos", false).value().find("mathbf\">q"), std::string::npos);
  ASSERT_TRUE(typesetter_.typeset("\\gdef\\qpos{p}\\qpos", false));
  EXPECT_NE(typesetter_.typeset("\\qpos", false).value().find("mathbf\">q"), std::string::npos);
}

TEST_F(TypesetterTest, UnknownCommandsAreFoundAndMended) {
  EXPECT_EQ(error("é + \\alhpa"), "");
  EXPECT_EQ(error("x + \\alhpa"), "");
  EXPECT_EQ(error("\\frca12"), "");
  EXPECT_EQ(error("\\qps"), "");
  EXPECT_EQ(error("\\xyzzyx"), "");
  EXPECT_EQ(error("x + \\bad"), "");
}

TEST_F(TypesetterTest, WhatLatexWouldRefuseIsAnError) {
  EXPECT_EQ(error("\\frac{1}{2"), "");
  EXPECT_EQ(error("x_1_2"), "");
  EXPECT_EQ(error("a + é"), "");
  EXPECT_EQ(error("\\left( x"), "");
}

}  // namespace mjcourse
