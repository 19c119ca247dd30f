#include "evaluate/scenes/svg_faults.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace mjcourse {
namespace {

constexpr const char* kOpen = "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 9 9'>";

constexpr const char* kXlink = "<g xmlns:xlink='http://www.w3.org/1999/xlink'>";

// Each fault: what is underlined, and what is said.
std::string faults(const std::string& bytes) {
  std::string text;
  for (const SvgFault& fault : faults_of_svg(bytes)) {
    text += (text.empty() ? "<" : "\n<") +
            bytes.substr(fault.span.begin, fault.span.end - fault.span.begin) + "> " +
            fault.message;
  }
  return text;
}

std::string inside(const std::string& content) {
  return faults(kOpen + content + "</svg>");
}

std::string element(const std::string& name) {
  return "<<" + name + "> a drawing cannot have the element `" + name + "`";
}
std::string attribute(const std::string& name) {
  return "<" + name + "> a drawing cannot have the attribute `" + name + "`";
}
std::string address(const std::string& name) {
  return "<" + name + "> a drawing cannot have an address outside of it";
}

TEST(SvgFaults, NoneInADrawing) {
  EXPECT_EQ(faults("<?xml version='1.0' encoding='utf-8' standalone='no'?>\n<!-- <script> -->\n" +
                   std::string(kOpen) + "</svg>"),
            "");
  EXPECT_EQ(
      inside("<title>f(x)</title><g fill='none' stroke-width='1' aria-label='f(x)'>"
             "<path d='M0 0' transform='rotate(9) translate(1,2)'/><text>a &lt; b</text></g>"),
      "");
  EXPECT_EQ(
      inside(std::string(kXlink) +
             "<linearGradient id='a' xlink:href='#b'/></g>"
             "<use href='#c'/><rect fill='url(#a)' style='fill: url(\"#a\"); color: rgb(1,2,3)'/>"
             "<image href='data:image/png;base64,iVBORw0KGgo='/>"),
      "");
  EXPECT_EQ(inside("<style>.a:not(.b) { fill: url(#a) }</style>"
                   "<style><![CDATA[ .a > .b { fill: #fff } ]]></style>"),
            "");
  EXPECT_EQ(faults("\xef\xbb\xbf<svg:svg xmlns:svg='http://www.w3.org/2000/svg'>"
                   "<svg:rect width='9'/></svg:svg>"),
            "");
  EXPECT_EQ(inside("<text>&#160;&apos;&quot;</text>"), "");
}

TEST(SvgFaults, AreWhatRuns) {
  EXPECT_EQ(inside("<script>alert(1)</script>"), element("script"));
  EXPECT_EQ(inside("<SCRIPT>alert(1)</SCRIPT>"), element("SCRIPT"));
  EXPECT_EQ(inside("<g><script href='x.js'/></g>"), element("script"));
  EXPECT_EQ(inside("<svg:script xmlns:svg='http://www.w3.org/2000/svg'>1</svg:script>"),
            element("svg:script"));
  EXPECT_EQ(inside("<h:script xmlns:h='http://www.w3.org/1999/xhtml'>alert(1)</h:script>"),
            element("h:script"));
  EXPECT_EQ(inside("<foreignObject><iframe xmlns='http://www.w3.org/1999/xhtml'/></foreignObject>"),
            element("foreignObject"));
  EXPECT_EQ(inside("<g xmlns='http://www.w3.org/1999/xhtml'><style>x</style></g>"),
            "<xmlns> a drawing cannot have elements of another language");
  EXPECT_EQ(faults("<svg xmlns='http://www.w3.org/2000/svg' width='9' height='9' onload='x()'/>"),
            attribute("onload"));
  EXPECT_EQ(inside("<g ONCLICK='x()'/><g onfocusin='x()' tabindex='1' autofocus=''/>"),
            attribute("ONCLICK") + "\n" + attribute("onfocusin") + "\n" + attribute("tabindex") +
                "\n" + attribute("autofocus"));
  EXPECT_EQ(inside("<handler type='application/javascript'>x</handler><listener/>"),
            element("handler") + "\n" + element("listener"));
}

TEST(SvgFaults, AreWhatMovesOrLeads) {
  EXPECT_EQ(inside("<a href='javascript:alert(1)'><text>x</text></a>"), element("a"));
  EXPECT_EQ(inside("<use id='u' href='#a'><set attributeName='href' to='javascript:x'/></use>"),
            element("set"));
  EXPECT_EQ(inside("<animate attributeName='href' values='javascript:x'/>"), element("animate"));
  EXPECT_EQ(inside("<use href='other.svg#a'/>"), address("href"));
  EXPECT_EQ(inside(std::string(kXlink) + "<use xlink:href=' java&#115;cript:alert(1)'/></g>"),
            address("xlink:href"));
  EXPECT_EQ(inside("<use href='data:image/svg+xml;base64,PHN2Zz4='/>"), address("href"));
  EXPECT_EQ(inside("<image href='data:image/svg+xml,&lt;svg onload=&quot;x&quot;/>'/>"),
            address("href"));
  EXPECT_EQ(inside("<image href='https://a.example/pixel.png'/>"), address("href"));
  EXPECT_EQ(inside("<feImage href='https://a.example/pixel.png'/>"), element("feImage"));
  EXPECT_EQ(inside("<rect fill='url(https://a.example/x#a)'/>"), address("fill"));
  EXPECT_EQ(inside("<rect style=\"fill: url( 'https://a.example/x' )\"/>"), address("style"));
  EXPECT_EQ(inside("<rect style='fill: u\\72l(x)'/>"),
            "<style> a drawing cannot have an escape in its style");
  EXPECT_EQ(inside("<rect style='fill: image-set(\"https://a.example/x\" 1x)'/>"),
            "<style> a drawing cannot have the function `image-set()` in its style");
  EXPECT_EQ(inside("<rect style='fill: URL(https://a.example/x)'/>"),
            "<style> a drawing cannot have the function `URL()` in its style");
  EXPECT_EQ(inside("<style>@import 'https://a.example/x.css';</style>"),
            "<<style> a drawing cannot have a rule with `@` in its style");
  EXPECT_EQ(inside("<style><![CDATA[a { fill: url(//a.example/x) }]]></style>"),
            "<<style> a drawing cannot have an address outside of it");
  EXPECT_EQ(inside("<g xml:base='https://a.example/'/>"), attribute("xml:base"));
}

TEST(SvgFaults, AreWhatBrowsersReadOtherwise) {
  const std::string instructions = "<<?> a drawing has no instructions for the browser";
  EXPECT_EQ(faults("<?xml version='1.0'?><?xml-stylesheet href='x.xsl' type='text/xsl'?>" +
                   std::string(kOpen) + "</svg>"),
            instructions);
  EXPECT_EQ(inside("<g/><?a b?><g/>"), instructions);
  const std::string declared = "<<?> a drawing is XML 1.0 in UTF-8, and says nothing else";
  EXPECT_EQ(faults("<?xml version='1.0' encoding='ISO-2022-JP'?>" + std::string(kOpen) + "</svg>"),
            declared);
  EXPECT_EQ(faults("<?xml version='1.1'?>" + std::string(kOpen) + "</svg>"), declared);
  const std::string doctype = "<<!DOCTYPE> a drawing has no `<!DOCTYPE>` and no entities";
  EXPECT_EQ(faults("<!DOCTYPE svg>" + std::string(kOpen) + "</svg>"), doctype);
  EXPECT_EQ(faults("<!DOCTYPE svg [<!ENTITY a '<script>alert(1)</script>'>]>" + std::string(kOpen) +
                   "&a;</svg>"),
            doctype);
  // Who has no entities of his own is told all at once.
  EXPECT_EQ(faults("<!DOCTYPE svg PUBLIC 'a' 'b'>" + std::string(kOpen) + "<a/>&b;</svg>"),
            doctype + "\n" + element("a"));
  EXPECT_EQ(faults(kOpen + std::string("</svg>\0<script/>", 16)),
            std::string("<") + '\0' + "> the drawing has a control character");
  EXPECT_EQ(faults("\xff\xfe<\0s"), "<\xff> the drawing is not in UTF-8");
  EXPECT_EQ(inside("<g a='1'/></svg><script/><svg>"),
            attribute("a") + "\n<<> the drawing is not XML: something follows its first element");
}

// A browser shows nothing at all of such a file.
TEST(SvgFaults, AreWhatIsNoXml) {
  const std::string no = " the drawing is not XML: ";
  EXPECT_EQ(faults(""), "<>" + no + "its end is missing");
  EXPECT_EQ(faults("a drawing"), "<a>" + no + "it begins with no element");
  EXPECT_EQ(faults("<svg"), "<<>" + no + "its end is missing");
  EXPECT_EQ(faults(kOpen + std::string("<g>")), "<>" + no + "its end is missing");
  EXPECT_EQ(faults(kOpen + std::string("<!-- a")), "<<>" + no + "its end is missing");
  EXPECT_EQ(inside("</svg><svg>"), "<<>" + no + "something follows its first element");
  EXPECT_EQ(inside("<g></p></g>"), "<p>" + no + "another element is to be closed first");
  EXPECT_EQ(inside("<text>a&nbsp;b</text>"), "<&nbsp;>" + no + "it has no character `&nbsp;`");
  EXPECT_EQ(inside("<g class='&lt;&#65;&lpar;'/>"),
            "<&lpar;>" + no + "it has no character `&lpar;`");
  EXPECT_EQ(inside("<text>a & b</text>"), "<&>" + no + "an `&` begins no character");
  EXPECT_EQ(inside("<text>a &amp b</text>"), "<&>" + no + "an `&` begins no character");
  EXPECT_EQ(inside("<text>&#0;</text>"), "<&>" + no + "no character has this number");
  EXPECT_EQ(inside("<!-- a -- b -->"), "<-->" + no + "a comment has `--` in it");
  EXPECT_EQ(inside("<text>a]]>b</text>"), "<]]>>" + no + "a text has `]]>` in it");
  EXPECT_EQ(inside("<g id='a<b'/>"), "<<>" + no + "a `<` begins nothing");
  EXPECT_EQ(inside("<g id=a/>"), "<a>" + no + "`a` cannot stand here");
  EXPECT_EQ(inside("<g id='a'class='b'/>"), "<c>" + no + "`c` cannot stand here");
  EXPECT_EQ(inside("<g id='a' id='b'/>"), "<i>" + no + "an element has this attribute twice");
  EXPECT_EQ(inside("<use xlink:href='#a'/>"),
            "<<>" + no + "a prefix in this element stands for nothing");
  EXPECT_EQ(faults("\n<?xml version='1.0'?>" + std::string(kOpen) + "</svg>"),
            "<<>" + no + "`<?xml` is not its beginning");
  EXPECT_EQ(faults_of_svg(kOpen + std::string("<text>&nbsp;</text></svg>")).at(0).cure,
            "write the character itself, or its number, as `&#160;`");
}

TEST(SvgFaults, AreWhatIsNoSvg) {
  EXPECT_EQ(faults("<svg width='9' height='9'><a/></svg>"),
            "<<svg> the drawing does not say that it is SVG\n" + element("a"));
  const std::string first = " the first element of a drawing is `svg`";
  EXPECT_EQ(faults("<html><script/></html>"), "<<html>" + first);
  EXPECT_EQ(faults("<svg xmlns='http://www.w3.org/1999/xhtml'/>"), "<<svg>" + first);
  EXPECT_EQ(faults("<h:svg xmlns:h='http://www.w3.org/1999/xhtml'/>"), "<<h:svg>" + first);
}

// However deep another language is hidden, and under whichever name.
TEST(SvgFaults, AreWhatHasAnotherNamespace) {
  const std::string other = "a drawing cannot have elements of another language";
  EXPECT_EQ(inside("<g xmlns='http://www.w3.org/1999/xlink'>"
                   "<script xmlns='http://www.w3.org/2000/svg'/></g>"),
            "<xmlns> " + other);
  EXPECT_EQ(inside("<g xmlns=''/>"), "<xmlns> " + other);
  EXPECT_EQ(inside("<g xmlns:xlink='http://www.w3.org/1999/xhtml'/>"), "<xmlns:xlink> " + other);
  EXPECT_EQ(inside("<g xmlns:ev='http://www.w3.org/2001/xml-events'/>"), attribute("xmlns:ev"));
  EXPECT_EQ(inside("<use xmlns:l='http://www.w3.org/1999/xlink' l:href='other.svg'/>"),
            address("l:href"));
  EXPECT_EQ(inside("<use xmlns:xlink='http://www.w3.org/2000/svg' xlink:href='other.svg'/>"),
            attribute("xlink:href"));
  EXPECT_EQ(faults("<s:svg xmlns:s='http://www.w3.org/2000/svg'><s:g><s:script/></s:g></s:svg>"),
            element("s:script"));
}

TEST(SvgFaults, AreElementsTooDeepInEachOther) {
  const auto nested = [](int groups) {
    std::string text;
    for (int i = 0; i < groups; ++i) text += "<g>";
    for (int i = 0; i < groups; ++i) text += "</g>";
    return inside(text);
  };
  EXPECT_EQ(nested(199), "");
  const std::string deep = "<<> elements of a drawing are at most 200 deep in each other";
  EXPECT_EQ(nested(200), deep);
  EXPECT_EQ(nested(1'000'000), deep);
}

TEST(SvgFaults, AreToldOnceOfEachKind) {
  EXPECT_EQ(inside("<g onclick='a'/><g onclick='b'/><script/><script/>"),
            attribute("onclick") + "\n" + element("script"));
}

TEST(SvgFaults, AreAHundredAtMost) {
  std::string content;
  for (int i = 0; i < 300; ++i) content += "<b" + std::to_string(i) + " a='1'/>";
  const std::string all = inside(content);
  EXPECT_EQ(std::ranges::count(all, '\n'), 99);
  EXPECT_TRUE(all.ends_with(element("b99")));
}

}  // namespace
}  // namespace mjcourse
