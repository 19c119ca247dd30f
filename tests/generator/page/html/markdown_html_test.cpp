#include "page/html/markdown_html.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <memory>

namespace mjcourse {
namespace {

// Writes nodes of the given types as [type:inner].
NodeWriter brackets(const std::vector<std::string>& types) {
  // While it is rendered, a node that the writer takes cannot tell its type.
  const auto taken = std::make_shared<std::map<cmark_node*, std::string>>();
  return {[=](cmark_node* node) {
            const std::string type = cmark_node_get_type_string(node);
            if (std::find(types.begin(), types.end(), type) == types.end()) return false;
            (*taken)[node] = type;
            return true;
          },
          [=](cmark_node* node, const std::string& inner) {
            return "[" + taken->at(node) + ":" + inner + "]";
          }};
}

std::string html(const std::string& markdown, const std::vector<std::string>& types = {}) {
  return render_html(parse_markdown(markdown).get(), brackets(types));
}

TEST(RenderHtml, LeavesToCmarkWhatTheWriterDoesNotTake) {
  EXPECT_EQ(html("*a* & <b>b</b>\n\n- ~~c~~\n"),
            "<p><em>a</em> &amp; <b>b</b></p>\n<ul>\n<li><del>c</del></li>\n</ul>\n");
}

TEST(RenderHtml, GivesTheWriterWhatIsInside) {
  EXPECT_EQ(html("a [*b*](c) d\n", {"link"}), "<p>a [link:<em>b</em>] d</p>\n");
  EXPECT_EQ(html("## a *b*\n", {"heading"}), "[heading:a <em>b</em>]");
}

TEST(RenderHtml, NestsTheWritersWork) {
  EXPECT_EQ(html("> > [*b*](c)\n", {"block_quote", "link", "emph"}),
            "[block_quote:[block_quote:<p>[link:[emph:b]]</p>\n]]");
}

TEST(RenderHtml, GivesNothingInsideALeaf) {
  EXPECT_EQ(html("`a` b\n\n```c\nd\n```\n\nlast\n", {"code", "code_block"}),
            "<p>[code:] b</p>\n[code_block:]\n<p>last</p>\n");
}

TEST(RenderHtml, LetsTheWriterHaveMath) {
  EXPECT_EQ(html("a $x$ b\n\n$$\ny\n$$\n", {"math", "math_block"}),
            "<p>a [math:] b</p>\n[math_block:]");
}

TEST(RenderHtml, LetsATableWriteItselfFirst) {
  const std::string table = html("| a | b |\n|:-:|--:|\n| *1* | 2 |\n", {"table", "emph"});
  EXPECT_TRUE(table.starts_with("[table:<table>")) << table;
  EXPECT_NE(table.find("<td align=\"center\">[emph:1]</td>"), std::string::npos) << table;
  EXPECT_TRUE(table.ends_with("</table>\n]")) << table;
}

TEST(RenderHtml, LeavesTheTreeAsItWas) {
  const Document document = parse_markdown("| a |\n|---|\n| ~~b~~ $c$ |\n\n- [ ] d\n\n`e`\n");
  const NodeWriter takes_all = brackets({"table", "strikethrough", "code", "list", "math"});
  const std::string once = render_html(document.get(), takes_all);
  EXPECT_EQ(render_html(document.get(), takes_all), once);
  const std::string plain = render_html(document.get(), brackets({"math"}));
  EXPECT_EQ(plain.find("<table>"), 0u) << plain;
  EXPECT_NE(plain.find("<del>b</del>"), std::string::npos) << plain;
}

TEST(RenderHtml, MakesNothingOfNothing) {
  EXPECT_EQ(render_html(nullptr, brackets({})), "");
}

std::string inline_html(const std::string& markdown) {
  return render_inline_html(parse_markdown(markdown).get(), brackets({}));
}

TEST(RenderInlineHtml, TakesAwayTheParagraphThatIsAlone) {
  EXPECT_EQ(inline_html("a *b*\n"), "a <em>b</em>");
  EXPECT_EQ(inline_html("a\n\nb\n"), "<p>a</p>\n<p>b</p>");
  EXPECT_EQ(inline_html("- a\n"), "<ul>\n<li>a</li>\n</ul>");
  EXPECT_EQ(inline_html("a\n\n- b\n"), "<p>a</p>\n<ul>\n<li>b</li>\n</ul>");
}

TEST(EscapeHtml, EscapesWhatHtmlMinds) {
  EXPECT_EQ(escape_html("<a href=\"x\">&amp; é</a>"),
            "&lt;a href=&quot;x&quot;&gt;&amp;amp; é&lt;/a&gt;");
}

}  // namespace
}  // namespace mjcourse
