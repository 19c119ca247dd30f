#include <gtest/gtest.h>

#include "reading_of.h"

namespace mjcourse {
namespace {

// Each mistake: its id and what is underlined.
std::string refused(const std::string& body) {
  std::string text;
  const ReadingOf reading = reading_of(body);
  for (const Diagnostic& d : reading.diagnostics) {
    const auto column = static_cast<std::size_t>(d.place.column - 1);
    text += (text.empty() ? "" : ", ") + d.id + " <" +
            d.place.excerpt.substr(column, static_cast<std::size_t>(d.place.width)) + ">";
  }
  return text;
}

std::string element(const std::string& underlined) {
  return "E-html-element <" + underlined + ">";
}
std::string attribute(const std::string& underlined) {
  return "E-html-attribute <" + underlined + ">";
}
std::string broken(const std::string& underlined) {
  return "E-html-broken <" + underlined + ">";
}
std::string style(const std::string& underlined) {
  return "E-html-style <" + underlined + ">";
}

TEST(RawHtml, MarksText) {
  EXPECT_EQ(refused("a<sub>1</sub> <kbd>Ctrl</kbd> <br> <br/> <BR /> <!-- not shown -->\n"), "");
  EXPECT_EQ(refused("<details open>\n<summary>More</summary>\n\nText.\n\n</details>\n"), "");
  EXPECT_EQ(refused("<table>\n<tr><td colspan=\"2\" title='a > b'>x &amp; y</td></tr>\n</table>\n"),
            "");
  EXPECT_EQ(refused("<div class=\"wide\" style=\"display: grid; gap: 0 1rem;\n"
                    "grid-template-columns: repeat(auto-fit, minmax(calc(10px + 2%), 1fr))\">\n"
                    "\n</div>\n"),
            "");
  EXPECT_EQ(refused("1 < 2, `<script>`, &lt;script> and \\<base>\n\n```xml mjcf\n<mujoco/>\n```\n"),
            "");
}

TEST(RawHtml, SaysWhereAndWhatToDo) {
  EXPECT_EQ(
      mistakes_in("> Some <b>text</b> and a\n> <span onclick='go()'>click</span>.\n"),
      R"(content/1-a/1.1-x.md:5:9: error: in a lesson, the element `span` cannot have `onclick` [E-html-attribute]
  5 | > <span onclick='go()'>click</span>.
    |         ^~~~~~~
  cure: known: class, dir, lang, style, title
)");
  EXPECT_EQ(
      mistakes_in("<div>\n<p>text\n  <iframe src='https://a.example'></iframe>\n</div>\n"),
      R"(content/1-a/1.1-x.md:6:3: error: a lesson cannot have the element `iframe` [E-html-element]
  6 |   <iframe src='https://a.example'></iframe>
    |   ^~~~~~~
  cure: leave it out; for the tag as text, write it as code, `` `<iframe>` ``, or `\<iframe>`
)");
  EXPECT_EQ(
      mistakes_in("See <img src='a.png'>.\n"),
      R"(content/1-a/1.1-x.md:4:5: error: a lesson cannot have the element `img` [E-html-element]
  4 | See <img src='a.png'>.
    |     ^~~~
  cure: show a picture: `![what it shows](picture.png)`
)");
  EXPECT_EQ(
      mistakes_in("<div style='colour: red'>\n"),
      R"(content/1-a/1.1-x.md:4:13: error: a lesson's style cannot have `colour` [E-html-style]
  4 | <div style='colour: red'>
    |             ^~~~~~
  cure: did you mean `color`?
)");
  EXPECT_EQ(mistakes_in("<div>\n\n<!-- never closed\n"),
            R"(content/1-a/1.1-x.md:6:1: error: this comment is never closed [E-html-broken]
  6 | <!-- never closed
    | ^~~~~~~~~~~~~~~~~
  cure: write `-->` where it ends; for the characters as text, `&lt;!--`
)");
  EXPECT_EQ(
      mistakes_in("<!--> b -->\n"),
      R"(content/1-a/1.1-x.md:4:1: error: to a browser, this comment ends before its `-->` [E-html-broken]
  4 | <!--> b -->
    | ^~~~~~~~~~~
  cure: begin it with a space, and write no `--!>` in it
)");
  EXPECT_EQ(
      mistakes_in("<?xml version=\"1.0\"?>\n"),
      R"(content/1-a/1.1-x.md:4:1: error: a lesson cannot have a declaration of HTML or XML [E-html-broken]
  4 | <?xml version="1.0"?>
    | ^~~~~~~~~~~~~~~~~~~~~
  cure: leave it out; to show it, write it as code
)");
  EXPECT_EQ(
      mistakes_in("A List<T>.\n"),
      R"(content/1-a/1.1-x.md:4:7: error: a lesson cannot have the element `T` [E-html-element]
  4 | A List<T>.
    |       ^~
  cure: leave it out; for the tag as text, write it as code, `` `<T>` ``, or `\<T>`
)");
  EXPECT_EQ(
      mistakes_in("<div>See <https://a.example/b>.</div>\n"),
      R"(content/1-a/1.1-x.md:4:10: error: a link right beside a tag is not Markdown, and a browser would not show it [E-html-hidden]
  4 | <div>See <https://a.example/b>.</div>
    |          ^~~~~~~~~~~~~~~~~~~~~
  cure: leave an empty line between the tag and it; for `<` as text, write `&lt;`
)");
}

// What runs a script, loads something, or leads elsewhere.
TEST(RawHtml, HasNoElementThatActs) {
  EXPECT_EQ(refused("<script>alert(1)</script>\n"), element("<script"));
  EXPECT_EQ(refused("a <ScRiPt src=\"//a.example/x.js\"></sCrIpT>\n"), element("<ScRiPt"));
  EXPECT_EQ(refused("a <base href=\"https://a.example/\"> b\n"), element("<base"));
  EXPECT_EQ(refused("<meta http-equiv=\"refresh\" content=\"0;url=https://a.example\">\n"),
            element("<meta"));
  EXPECT_EQ(refused("<form action=\"https://a.example\">\n<input name=\"password\">\n</form>\n"),
            element("<form") + ", " + element("<input"));
  EXPECT_EQ(refused("a <object data=\"x.svg\"></object>\n"), element("<object"));
  EXPECT_EQ(refused("a <embed src=\"x.svg\"> b\n"), element("<embed"));
  EXPECT_EQ(refused("<link rel=\"stylesheet\" href=\"https://a.example/x.css\">\n"),
            element("<link"));
  EXPECT_EQ(refused("<style>@import 'https://a.example/x.css';</style>\n"), element("<style"));
  EXPECT_EQ(refused("a <svg><script>alert(1)</script></svg>\n"),
            element("<svg") + ", " + element("<script"));
  EXPECT_EQ(refused("a <svg/onload=alert(1)> b\n"), "");  // to Markdown, this is text
  EXPECT_EQ(refused("a <math><mi xlink:href=\"javascript:alert(1)\">x</mi></math>\n"),
            element("<math") + ", " + element("<mi"));
  EXPECT_EQ(refused("a <a href=\"java&#115;cript&colon;alert(1)\">x</a>\n"), element("<a"));
  EXPECT_EQ(refused("a <a href=\"jAvA\tscript:alert(1)\">x</a>\n"), element("<a"));
  EXPECT_EQ(refused("a <a href=\"data:text/html,<script>alert(1)</script>\">x</a>\n"),
            element("<a"));
  EXPECT_EQ(refused("a <img src=x onerror=alert(1)> b\n"), broken("<img src=x onerror=alert(1)>"));
  EXPECT_EQ(refused("<textarea>\n</textarea>\n"), element("<textarea"));
  EXPECT_EQ(refused("<template>\n<b>x</b>\n</template>\n"), element("<template"));
  EXPECT_EQ(refused("<noscript><p title=\"</noscript><img src=x onerror=alert(1)>\">\n"),
            element("<noscript"));
  EXPECT_EQ(refused("<sim-lab data-module=\"labs/x.js\"></sim-lab>\n"), element("<sim-lab"));
  EXPECT_EQ(refused("a </main> b </main>\n"), element("</main"));
  EXPECT_EQ(refused("a <u>b</u> <a>c</a> <a>d</a>\n"), element("<a") + ", " + element("<a"));
}

TEST(RawHtml, HasNoAttributeThatActs) {
  EXPECT_EQ(refused("a <b ONCLICK='alert(1)'>x</b>\n"), attribute("ONCLICK"));
  EXPECT_EQ(refused("<details open ontoggle=\"alert(1)\">\n</details>\n"), attribute("ontoggle"));
  EXPECT_EQ(refused("<div\nonmouseover\n=\n\"alert(1)\">\n</div>\n"), attribute("onmouseover"));
  EXPECT_EQ(refused("a <span id=\"search\" name=\"search\">x</span>\n"),
            attribute("id") + ", " + attribute("name"));
  EXPECT_EQ(refused("a <q cite=\"javascript:alert(1)\">x</q>\n"), attribute("cite"));
  EXPECT_EQ(refused("<table background=\"https://a.example/x.png\">\n</table>\n"),
            attribute("background"));
  EXPECT_EQ(refused("a <b popover autofocus tabindex=\"1\">x</b>\n"),
            attribute("popover") + ", " + attribute("autofocus") + ", " + attribute("tabindex"));
  EXPECT_EQ(refused("a <div data-module=\"x.js\" is=\"sim-lab\">x</div>\n"),
            attribute("data-module") + ", " + attribute("is"));
}

// What browsers take for another thing than it seems.
TEST(RawHtml, IsWrittenWhole) {
  EXPECT_EQ(refused("<!--> <script>alert(1)</script> -->\n"),
            broken("<!--> <script>alert(1)</script> -->"));
  EXPECT_EQ(refused("<!---> <script>alert(1)</script> -->\n"),
            broken("<!---> <script>alert(1)</script> -->"));
  EXPECT_EQ(refused("<!-- --!> <script>alert(1)</script> -->\n"),
            broken("<!-- --!> <script>alert(1)</script> -->"));
  EXPECT_EQ(refused("<?php <script>alert(1)</script> ?>\n"),
            broken("<?php <script>alert(1)</script> ?>"));
  EXPECT_EQ(refused("<!DOCTYPE html><script>alert(1)</script>\n"),
            broken("<!DOCTYPE html><script>alert(1)</script>"));
  EXPECT_EQ(refused("a <![CDATA[<script>alert(1)</script>]]> b\n"),
            broken("<![CDATA[<script>alert(1)</script>]]>"));
  EXPECT_EQ(refused("<div title=\"\n\n<script>alert(1)</script>\n"),
            broken("<div title=\"") + ", " + element("<script"));
  EXPECT_EQ(refused("<div title=`\"><script>alert(1)</script>`>\n"),
            broken("<div title=`\"><script>alert(1)</script>`>"));
  EXPECT_EQ(refused("<p title=\"a\"onclick=\"alert(1)\">\n"),
            broken("<p title=\"a\"onclick=\"alert(1)\">"));
  EXPECT_EQ(refused("<p/onclick=\"alert(1)\">\n"), "");  // text, too
  EXPECT_EQ(refused("<div <script>alert(1)</script>\n"), broken("<div <script>alert(1)</script>"));
}

// A style of a lesson becomes a rule of the page's own sheet.
TEST(RawHtml, HasStylesThatStayInTheirPlace) {
  EXPECT_EQ(refused("a <b style=\"color: red} body {display: none\">x</b>\n"), style("}"));
  EXPECT_EQ(refused("a <b style=\"position: fixed; inset: 0\">x</b>\n"), style("position"));
  EXPECT_EQ(refused("a <b style=\"border: url(https://a.example/x)\">x</b>\n"), style("url"));
  EXPECT_EQ(refused("a <b style=\"border: url(x)\">x</b>\n"), style("url"));
  EXPECT_EQ(refused("a <b style=\"border: u\\72l(x)\">x</b>\n"), style("\\"));
  EXPECT_EQ(refused("a <b style=\"border: u/**/rl(x)\">x</b>\n"), style("/"));
  EXPECT_EQ(refused("a <b style=\"border: u&#114;l(x)\">x</b>\n"), style("&"));
  EXPECT_EQ(refused("a <b style=\"color: rgb(1, 2\">x</b>\n"), style(" rgb(1, 2"));
  EXPECT_EQ(refused("a <b style=\"@import 'x'\">x</b>\n"), style("@import 'x'"));
  EXPECT_EQ(refused("a <b style=\"--accent: red\">x</b>\n"), style("--accent"));
}

std::string nesting(const std::string& underlined) {
  return "E-html-nesting <" + underlined + ">";
}

TEST(RawHtml, ClosesWhatItOpens) {
  EXPECT_EQ(refused("<div>\n\nText with <b>*words*</b>.\n\n</div>\n"), "");
  EXPECT_EQ(refused("> <div>\n>\n> - <p>\n>\n> </div>\n"), "");
  EXPECT_EQ(refused("<ul>\n<li>one\n<li>two\n</ul>\n\na<br>b<hr/><wbr>\n"), "");
  EXPECT_EQ(refused("<table>\n<tr><td>a<td>b\n<tr><td>\n\n**c**\n\n<td>d\n</table>\n"), "");
  EXPECT_EQ(refused("<div>\n\nText.\n"), nesting("<div>"));
  EXPECT_EQ(refused("<details>\n<summary>\n\nText.\n\n</details>\n"), nesting("<summary>"));
  EXPECT_EQ(refused("a <b>c\n\nd</b>\n"), nesting("<b>"));
  EXPECT_EQ(refused("<div>\n\n> </div>\n"), nesting("</div>"));
  EXPECT_EQ(refused("a <b>*c</b>*\n"), nesting("</b>"));
  EXPECT_EQ(refused("<b><i>a</b></i>\n"), nesting("<i>"));
  EXPECT_EQ(refused("a </sub> b</br> <span/>c\n"),
            nesting("</sub>") + ", " + nesting("</br>") + ", " + nesting("<span/>"));
  EXPECT_EQ(refused("| <b>a |\n|---|\n| b</b> |\n"), nesting("<b>"));
}

TEST(RawHtml, IsNotTwiceRefusedForOneTag) {
  EXPECT_EQ(refused("a<b and c>d\n"), attribute("and") + ", " + attribute("c"));
  EXPECT_EQ(refused("The <joint> is open\n"), element("<joint"));
  EXPECT_EQ(refused("<div class=a>\n\ntext\n\n<b>\n"), broken("<div class=a>"));
}

std::string hidden(const std::string& underlined) {
  return "E-html-hidden <" + underlined + ">";
}

TEST(RawHtml, HidesNoMarkdown) {
  EXPECT_EQ(refused("<details>\n```text unchecked\ncode\n```\n</details>\n"), hidden("```"));
  EXPECT_EQ(refused("<div>\ntext $x$\n</div>\n"), hidden("$x$"));
  EXPECT_EQ(refused("<div>\nIt has `{p} model.nq`.\n</div>\n"), hidden("`{p} model.nq`"));
  EXPECT_EQ(refused("<div>\n$$\nx\n$$\n</div>\n"), hidden("$$"));
  EXPECT_EQ(refused("<div>\n## A heading\n</div>\n"), hidden("##"));
  EXPECT_EQ(refused("<div>\n- an item\n</div>\n"), hidden("-"));
  EXPECT_EQ(refused("<div>\n> [!note] a\n</div>\n"), hidden("> [!"));
  EXPECT_EQ(refused("<div>\na [[term]]\n</div>\n"), hidden("[[term]]"));
  EXPECT_EQ(refused("<div><b>a</b> ![b](c.png)</div>\n"), hidden("[b](c.png)"));
  EXPECT_EQ(refused("> <summary>$x$</summary>\n"), hidden("$x$"));
  EXPECT_EQ(refused("<div>\n# A title\n</div>\n"), hidden("#"));
  EXPECT_EQ(refused("<div>\na | b\n---|:-:\n1 | 2\n</div>\n"), hidden("---|:-:"));
  EXPECT_EQ(refused("<div>a **b c** d</div>\n"), hidden("**b c**"));
  EXPECT_EQ(refused("<div>\n*b*\n</div>\n"), hidden("*b*"));
  EXPECT_EQ(refused("<div>\na __b__ and _c_\n</div>\n"), hidden("__b__") + ", " + hidden("_c_"));
  EXPECT_EQ(refused("<div>\n_c d_, e\n</div>\n"), hidden("_c d_"));
  EXPECT_EQ(refused("<div>\n~~b~~ c\n</div>\n"), hidden("~~b~~"));
  EXPECT_EQ(refused("<div>\na[^1]\n</div>\n\nb[^1]\n\n[^1]: c\n"), hidden("[^1]"));
}

TEST(RawHtml, IsToldOfAllThatItHides) {
  EXPECT_EQ(refused("<div>\ntext $x$ `a` <b>[t](1.1)</b>\n## b\n- [[c]]\n- d\n</div>\n"),
            hidden("$x$") + ", " + hidden("`a`") + ", " + hidden("[t](1.1)") + ", " + hidden("##") +
                ", " + hidden("-") + ", " + hidden("[[c]]"));
  EXPECT_EQ(refused("<div>\n```\n$x$\n```\n$$\n`a`\n$$\n$y$\n</div>\n"),
            hidden("```") + ", " + hidden("$$") + ", " + hidden("$y$"));
}

TEST(RawHtml, LeavesMarkdownWhereItIsReadOrIsCode) {
  EXPECT_EQ(refused("<details>\n\n```text unchecked\ncode\n```\n\n</details>\n"), "");
  EXPECT_EQ(refused("<pre>\n$x$\n\n## a `b`\n</pre>\n"), "");
  EXPECT_EQ(refused("<p>a <code>$HOME/`x`$</code>, $5 and $6, 2 - 1, [1](\n</p>\n"), "");
  EXPECT_EQ(refused("<p>2*3*4, a_b_c, x * y * z, snake_case_, --- or - | -, 1 ~ 2, ** </p>\n"), "");
  EXPECT_EQ(refused("<!-- use --strict, and `x` -->\n"), "");
  EXPECT_EQ(refused("<!-- $x$ `a` -->\n"), "");
  EXPECT_EQ(refused("a <kbd>Ctrl</kbd> $x$ `b`\n"), "");
}

TEST(RawHtml, SaysHowItIsWrittenOtherwise) {
  EXPECT_EQ(
      mistakes_in("A std::vector<int>, and a<b and c>d.\n\n<div>\n$x$\n"),
      R"(content/1-a/1.1-x.md:4:14: error: a lesson cannot have the element `int` [E-html-element]
  4 | A std::vector<int>, and a<b and c>d.
    |              ^~~~
  cure: leave it out; for the tag as text, write it as code, `` `<int>` ``, or `\<int>`
content/1-a/1.1-x.md:4:29: error: in a lesson, the element `b` cannot have `and` [E-html-attribute]
  4 | A std::vector<int>, and a<b and c>d.
    |                             ^~~
  cure: leave it out; for `<` as text, write code, `` `a<b` ``, or `\<`
content/1-a/1.1-x.md:4:33: error: in a lesson, the element `b` cannot have `c` [E-html-attribute]
  4 | A std::vector<int>, and a<b and c>d.
    |                                 ^
  cure: leave it out; for `<` as text, write code, `` `a<b` ``, or `\<`
content/1-a/1.1-x.md:7:1: error: a formula right beside a tag is not Markdown, and is shown as it is written [E-html-hidden]
  7 | $x$
    | ^~~
  cure: leave an empty line between the tag and it
content/1-a/1.1-x.md:6:1: error: this `<div>` is never closed [E-html-nesting]
  6 | <div>
    | ^~~~~
  cure: write `</div>` where it ends
)");
}

TEST(RawHtml, IsTheSameInAllMarkdown) {
  EXPECT_EQ(refused("> [!note] A <blink>title</blink>\n>\n> text\n"), element("<blink"));
  EXPECT_EQ(refused("| <iframe> |\n|---|\n| x |\n"), element("<iframe"));
  EXPECT_EQ(refused("```io\nINPUT: <iframe>\n```\n"), element("<iframe"));
  EXPECT_EQ(refused("````demo\n<iframe>\n````\n"), element("<iframe"));
  EXPECT_EQ(refused("[^1]\n\n[^1]: <iframe>\n"), element("<iframe"));
}

}  // namespace
}  // namespace mjcourse
