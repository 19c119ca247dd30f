#include "page/blocks/page_writer.h"

#include <gtest/gtest.h>

#include "page/page_fixture.h"

namespace mjcourse {
namespace {

TEST_F(PageWriterTest, GivesHeadingsTheirAnchors) {
  EXPECT_EQ(body("## A *b*\n### C\n## A b\n"),
            "<h2 id=\"a-b\"><a class=\"anchor\" href=\"#a-b\">A <em>b</em></a></h2>\n"
            "<h3 id=\"c\"><a class=\"anchor\" href=\"#c\">C</a></h3>\n"
            "<h2 id=\"a-b-2\"><a class=\"anchor\" href=\"#a-b-2\">A b</a></h2>\n");
  ASSERT_EQ(contents_.size(), 2u);
  EXPECT_EQ(contents_[0]["title"], "A <em>b</em>");
  EXPECT_EQ(contents_[0]["children"][0]["id"], "c");
  EXPECT_EQ(contents_[1]["id"], "a-b-2");
}

TEST_F(PageWriterTest, LeadsLinksToTheirPages) {
  EXPECT_EQ(
      body("[a](1.2) [b](1.2#there)\n"),
      "<p><a href=\"../1-a/1.2-y.html\">a</a> <a href=\"../1-a/1.2-y.html#there\">b</a></p>\n");
  EXPECT_TRUE(body("[c](#d)\n## D\n").starts_with("<p><a href=\"#d\">c</a></p>\n"));
  EXPECT_EQ(body("[e](https://f.example/?g&h)\n"),
            "<p><a class=\"external\" href=\"https://f.example/?g&amp;h\">e</a></p>\n");
  EXPECT_EQ(body("[e](<https://f.example/g\\h \"i\">)\n"),
            "<p><a class=\"external\" href=\"https://f.example/g%5Ch%20%22i%22\">e</a></p>\n");
}

TEST_F(PageWriterTest, GivesLinksTheirTitles) {
  EXPECT_EQ(body("[a](1.2 \"Two & more\") [b](HTTPS://f.example '<c>')\n"),
            "<p><a href=\"../1-a/1.2-y.html\" title=\"Two &amp; more\">a</a> <a class=\"external\" "
            "href=\"HTTPS://f.example\" title=\"&lt;c&gt;\">b</a></p>\n");
}

TEST_F(PageWriterTest, LeadsLinksToPagesThatNoLessonIs) {
  course_.models = {"zoo"};
  EXPECT_EQ(
      body("[a](model:zoo) [b](api:mjModel.nq)\n"),
      "<p><a href=\"../models/zoo.html\">a</a> <a href=\"../api.html#mjModel-nq\">b</a></p>\n");
}

TEST_F(PageWriterTest, LeadsLinksFromTheFrontPage) {
  const PageWriter unused = writer("[a](1.2) [b](#c)\n\n## C\n");
  PageWriter home(course_, course_.lessons[0], results_,
                  {*templates_, *highlighter_, manifest_, styles_, "index.html"});
  EXPECT_TRUE(home.body().starts_with(
      "<p><a href=\"1-a/1.2-y.html\">a</a> <a href=\"1-a/1.1-x.html#c\">b</a></p>\n"));
}

TEST_F(PageWriterTest, ShowsPicturesInTheirSize) {
  results_.of_block[0] = ImageResult{"/nowhere/a b.png", "0123456789", 30, 20};
  EXPECT_EQ(body("![An \\<arm>](<a b.png> \"By hand\")\n"),
            "<figure class=\"image\">\n<img src=\"../1-a/1.1-x/a-b-0123456789.png\" width=\"30\" "
            "height=\"20\" alt=\"An &lt;arm&gt;\" loading=\"lazy\" decoding=\"async\">\n"
            "<figcaption>By hand</figcaption>\n</figure>\n");
  EXPECT_EQ(body("A ![b](b.png).\n"),
            "<p>A <img class=\"in-line\" src=\"../1-a/1.1-x/b-0123456789.png\" width=\"30\" "
            "height=\"20\" alt=\"b\" loading=\"lazy\" decoding=\"async\">.</p>\n");
}

TEST_F(PageWriterTest, AlignsTheCellsOfATableByClass) {
  const std::string table = body("| a | b | c |\n|:--|:-:|--:|\n| 1 | 2 | 3 |\n");
  EXPECT_TRUE(table.starts_with("<div class=\"table\"><table>")) << table;
  EXPECT_NE(table.find("<th>a</th>\n<th class=\"center\">b</th>\n<th class=\"end\">c</th>"),
            std::string::npos)
      << table;
  EXPECT_NE(table.find("<td>1</td>\n<td class=\"center\">2</td>\n<td class=\"end\">3</td>"),
            std::string::npos)
      << table;
  EXPECT_TRUE(table.ends_with("</table>\n</div>\n")) << table;
}

TEST_F(PageWriterTest, SaysTheStateOfATask) {
  EXPECT_EQ(body("- [x] a\n- [ ] b\n"),
            "<ul>\n<li><input type=\"checkbox\" aria-label=\"done\" checked=\"\" disabled=\"\" /> "
            "a</li>\n"
            "<li><input type=\"checkbox\" aria-label=\"to do\" disabled=\"\" /> b</li>\n</ul>\n");
}

TEST_F(PageWriterTest, ShowsAFormulaWithoutResultAsItsTeX) {
  EXPECT_EQ(body("a $x < y$\n"), "<p>a <span class=\"math\">x &lt; y</span></p>\n");
}

TEST_F(PageWriterTest, DisplaysAFormulaAlsoInsideOfAParagraph) {
  EXPECT_EQ(body("$$\nx\n$$\n"), "<div class=\"math display\">\nx\n</div>\n");
  EXPECT_EQ(body("a\n$$x$$\nb\n"), "<p>a\n<span class=\"math display\">x</span>\nb</p>\n");
}

TEST_F(PageWriterTest, PutsAFormulasMarkupInItsPlace) {
  results_.of_block[0] = FormulaResult{"<i>x</i>"};
  EXPECT_EQ(body("a $x$\n"), "<p>a <span class=\"math\"><i>x</i></span></p>\n");
  const std::string table = body("| a |\n|---|\n| $x$ |\n");
  EXPECT_NE(table.find("<td><span class=\"math\"><i>x</i></span></td>"), std::string::npos)
      << table;
}

TEST_F(PageWriterTest, LetsAReaderRunAProgramWhereTheSiteHasACompiler) {
  const std::string fence = "```cpp file=examples/x.cpp args=\"a 'b'\" expect=exit:3\n```\n";
  const std::string same = "```text\n0.5\n```\n", gap = "```text tol=1\n0[..]\n```\n";
  ExampleResult ran{"int main() {}\n", "0.5\n"};
  ran.page = PageRun{};
  results_.of_block[0] = ran;
  EXPECT_EQ(body(fence).find("data-program"), std::string::npos);
  for (const char* name : {"program.js", "program.css", "cpp.js", "llvm.wasm.xz", "cpp.pack.xz",
                           "engine.mjs", "engine.wasm", "lab.css"}) {
    manifest_[name] = std::string("assets/") + name;
  }
  EXPECT_EQ(body(fence + same).find("data-outputs"), std::string::npos);
  const std::string html = body(fence + gap);
  for (const char* attribute :
       {" data-program=\"examples/x.cpp\"", " data-code=\"../assets/program.js\"",
        " data-style=\"../assets/program.css\"", " data-worker=\"../assets/cpp.js\"",
        " data-llvm=\"../assets/llvm.wasm.xz\"", " data-pack=\"../assets/cpp.pack.xz\"",
        " data-engine=\"../assets/engine.mjs\"", " data-wasm=\"../assets/engine.wasm\"",
        " data-lab-style=\"../assets/lab.css\"", " data-bytes=\"0\"",
        " data-arguments=\"[&quot;a&quot;,&quot;&#x27;b&#x27;&quot;]\"", " data-exit=\"3\"",
        " data-outputs=\"[{&quot;text&quot;:&quot;0[..]\\n&quot;,&quot;tolerance&quot;:1.0}]\""}) {
    EXPECT_NE(html.find(attribute), std::string::npos) << attribute << " in " << html;
  }
  EXPECT_EQ(body("```cpp file=examples/x.cpp expect=compile-error\n```\n").find("data-program"),
            std::string::npos)
      << "it cannot be run";
  ran.page->why_not = "it waits";
  results_.of_block[0] = ran;
  const std::string without = body(fence);
  EXPECT_EQ(without.find("data-program"), std::string::npos);
  EXPECT_NE(without.find("Not in the page: it waits"), std::string::npos) << without;
}

TEST_F(PageWriterTest, WritesAValueAsTextThatKnowsItsOrigin) {
  course_.models = {"zoo"};
  results_.of_block[0] = ValueResult{"a < b", "x[\"y\"] of zoo.xml"};
  const std::string value =
      "<span class=\"value\" title=\"computed: x[&quot;y&quot;] of zoo.xml\">a &lt; b</span>";
  EXPECT_EQ(body("a `{zoo} x` `{x}`\n"), "<p>a " + value + " <code>{x}</code></p>\n");
  const std::string table = body("| a |\n|---|\n| `{zoo} x` |\n");
  EXPECT_NE(table.find("<td>" + value + "</td>"), std::string::npos) << table;
  results_.of_block[1] = results_.of_block[0];  // the callout itself comes first
  const std::string callout = body("> [!note] Of `{zoo} x`\n> Text.\n");
  EXPECT_NE(callout.find("Of " + value), std::string::npos) << callout;
}

TEST_F(PageWriterTest, NamesTheResultThatAValueQuotes) {
  results_.of_block[0] = ValueResult{"8.0", "depth of fall.cpp"};
  EXPECT_EQ(body("`{fall} depth :.1f`\n"),
            "<p><span class=\"value\" data-quotes=\"fall\" data-result=\"depth\" "
            "data-format=\".1f\" title=\"computed: depth of fall.cpp\">8.0</span></p>\n");
}

TEST_F(PageWriterTest, KeepsTogetherWhatALinesEndMayNotPart) {
  course_.models = {"zoo"};
  results_.of_block[0] = ValueResult{"8", "x"};
  const std::string value = "<span class=\"value\" title=\"computed: x\">8</span>";
  EXPECT_EQ(body("`{zoo} x` mm, & so\n"),
            "<p><span class=\"with-unit\">" + value + " mm,</span> &amp; so</p>\n");
  EXPECT_EQ(body("`{zoo} x`, so\n"), "<p>" + value + ", so</p>\n");
  results_.of_block[0] = FormulaResult{"<i>x</i>"};
  const std::string math = "<span class=\"math\"><i>x</i></span>";
  EXPECT_EQ(body("of $x$.\n"), "<p>of <span class=\"with-mark\">" + math + ".</span></p>\n");
  EXPECT_EQ(body("$x$ mm\n"), "<p><span class=\"with-unit\">" + math + " mm</span></p>\n");
  EXPECT_EQ(body("$x + y + z$ mm\n"), "<p>" + math + " mm</p>\n") << "a line may end in it";
  EXPECT_EQ(body("$x$ is\n"), "<p>" + math + " is</p>\n");
}

TEST_F(PageWriterTest, SaysThatAProgramProvedAnAnswer) {
  course_.models = {"zoo"};
  QuestionResult question;
  question.proved = question.by_program = true;
  question.proofs = {{"tell.cpp", "ratio", "0.5"}};
  results_.of_block[0] = ValueResult{"8", "model.nq of zoo.xml"};
  results_.of_block[1] = QuizResult{{question}};
  const std::string html = body(
      "```quiz\n{\"id\": \"q\", \"questions\": [{\"kind\": \"numeric\", \"q\": \"Of `{zoo} x`?\", "
      "\"answer\": 0.5}]}\n```\n");
  EXPECT_NE(html.find("proved by running the program</p>"), std::string::npos) << html;
  EXPECT_NE(html.find("<li><code>ratio</code> is 0.5 in tell.cpp</li>"), std::string::npos) << html;
  EXPECT_NE(html.find("Of <span class=\"value\" title=\"computed: model.nq of zoo.xml\">8</span>?"),
            std::string::npos)
      << html;
}

TEST_F(PageWriterTest, WritesWhatACalloutHoldsIntoIt) {
  const std::string html = body("> [!pitfall] Of $q$\n> The *body*.\n");
  EXPECT_NE(html.find("Of <span class=\"math\">q</span>"), std::string::npos) << html;
  EXPECT_NE(html.find("<p>The <em>body</em>.</p>"), std::string::npos) << html;
  EXPECT_EQ(html.find("<blockquote>"), std::string::npos) << html;
}

TEST_F(PageWriterTest, ShowsADemosSourceAboveWhatItBecomes) {
  const std::string html = body("## A\n````demo\n### B\n> [!note] C\n> <b>d</b>\n````\n## E\n");
  EXPECT_NE(html.find("<span class=\"hljs-section\">### B</span>\n&gt; [!note] C"),
            std::string::npos)
      << html;
  const std::size_t result = html.find("<div class=\"demo-page prose\">\n<h3 id=\"b\">");
  ASSERT_NE(result, std::string::npos) << html;
  EXPECT_NE(html.find("<p><b>d</b></p>", result), std::string::npos) << html;
  ASSERT_EQ(contents_.size(), 2u);
  EXPECT_TRUE(contents_[0]["children"].empty());
}

TEST_F(PageWriterTest, ShowsAnOutputOnlyWithItsExample) {
  results_.of_block[0] = ExampleResult{"int main() {}\n", "the real output\n"};
  const std::string html =
      body("```cpp file=examples/a.cpp\n```\n\nOutput:\n\n```text\nstated\n```\n\nAfter.\n");
  EXPECT_NE(html.find("the real output"), std::string::npos) << html;
  EXPECT_EQ(html.find("stated"), std::string::npos) << html;
  EXPECT_EQ(html.find("<p>Output:</p>"), std::string::npos) << html;
  EXPECT_TRUE(html.ends_with("<p>After.</p>\n")) << html;
}

TEST_F(PageWriterTest, ShowsAnOutputThatStandsElsewhereWhereItStands) {
  results_.of_block[0] = ExampleResult{"int main() {}\n", "real\n"};
  results_.of_block[1] = OutputResult{1};
  const std::string program = "```cpp file=examples/a.cpp\n```\n";
  const std::string apart = body(program + "Text.\n```text output=a\nstated\n```\n");
  const std::size_t output = apart.find("<samp>real\n</samp>");
  ASSERT_NE(output, std::string::npos) << apart;
  EXPECT_LT(apart.find("<p>Text.</p>"), output) << apart;
  EXPECT_EQ(apart.find("<samp>", output + 1), std::string::npos) << apart;
  EXPECT_NE(apart.find("<span>Printed by examples/a.cpp</span> <span class=\"mark proved\">"),
            std::string::npos)
      << apart;
}

TEST_F(PageWriterTest, ShowsAnOutputThatIsStatedTwiceBelowItsProgramOnce) {
  results_.of_block[0] = ExampleResult{"int main() {}\n", "real\n"};
  results_.of_block[1] = OutputResult{1};
  const std::string twice =
      "```cpp file=examples/a.cpp\n```\n```text\n1\n```\n```text output=a\n2\n```\n";
  const std::string html = body(twice);
  EXPECT_EQ(html.find("<samp>"), html.rfind("<samp>")) << html;
  EXPECT_EQ(html.find("mark proved"), std::string::npos) << "one of them is not so";
  results_.of_block[2] = OutputResult{1};
  EXPECT_NE(body(twice).find("mark proved"), std::string::npos);
}

TEST_F(PageWriterTest, GivesEachListingAnIdOfItsOwn) {
  const std::string html = body(
      "## Example a\n```cpp file=examples/a.cpp\n```\n```cpp file=examples/a.cpp\n```\n"
      "```cpp file=examples/b.cpp\n```\n");
  for (const char* id : {"example-a", "example-a-2", "example-a-3", "example-b"}) {
    const std::string attribute = "id=\"" + std::string(id) + "\"";
    EXPECT_NE(html.find(attribute), std::string::npos) << html;
    EXPECT_EQ(html.find(attribute), html.rfind(attribute)) << html;
  }
}

TEST_F(PageWriterTest, SaysHowAProgramWasRun) {
  results_.of_block[0] = ExampleResult{"int main() {}\n", "out\n"};
  EXPECT_NE(body("```cpp file=examples/a.cpp args=\"x y\" expect=exit:3\n```\n")
                .find("<span>Printed by this program when run with x y, which exits with code 3"),
            std::string::npos);
  EXPECT_NE(body("```cpp file=examples/a.cpp expect=compile-error\n```\n")
                .find("<span>Said by the compiler, which refuses this program</span>"),
            std::string::npos);
}

TEST_F(PageWriterTest, ShowsAnOutputBelowTheRegionThatStatesIt) {
  results_.of_block[0] = ExampleResult{"x;\n", "out\n"};
  const std::string silent = body("```cpp file=examples/a.cpp#r\n```\n");
  EXPECT_NE(silent.find("id=\"example-a-r\""), std::string::npos) << silent;
  EXPECT_EQ(silent.find("out\n"), std::string::npos) << silent;
  EXPECT_NE(body("```cpp file=examples/a.cpp#r\n```\n```text\nout\n```\n").find("out\n"),
            std::string::npos);
}

TEST_F(PageWriterTest, SaysOfUncheckedCodeThatItWasNotRun) {
  const std::string html = body("```cpp unchecked\na < b;\n```\n");
  EXPECT_NE(html.find("<span class=\"mark asserted\">not run</span>"), std::string::npos) << html;
  EXPECT_NE(html.find("a &lt; b;"), std::string::npos) << html;
}

TEST_F(PageWriterTest, ShowsOfASnippetWhatIsToBeSeen) {
  results_.of_block[0] = ExampleResult{"use(n);\n", "out\n"};
  const std::string html = body("```cpp snippet model=m\n//| int n = 2;\nuse(n);\n```\n");
  EXPECT_EQ(html.find("n = "), std::string::npos) << html;
  EXPECT_NE(html.find("<span>Printed by these lines</span>"), std::string::npos) << html;
  EXPECT_NE(html.find("_1.zip\" download>Zip to build</a>"), std::string::npos) << html;
  EXPECT_NE(html.find("<samp>out\n</samp>"), std::string::npos) << html;
}

TEST_F(PageWriterTest, ShowsWhatCommandsPrintWhereTheLessonStatesIt) {
  results_.of_block[0] = ExampleResult{"ls\n", "out\n"};
  EXPECT_EQ(body("```sh run\nls\n```\n").find("<samp>"), std::string::npos);
  const std::string html = body("```sh run\nls\n```\n```text\nout\n```\n");
  EXPECT_NE(html.find("<span>Printed by these commands</span>"), std::string::npos) << html;
  EXPECT_NE(html.find("<samp>out\n</samp>"), std::string::npos) << html;
}

TEST_F(PageWriterTest, ShowsModelsAndWhyMuJoCoRefusesThem) {
  const std::string excerpt = body("```xml model=ball\n<geom/>\n```\n");
  EXPECT_NE(excerpt.find("<span class=\"file\">models/ball.xml</span></figcaption>"),
            std::string::npos)
      << excerpt;
  results_.of_block[0] = ModelResult{"line 1: no <mujoco>\n"};
  const std::string refused = body("```xml mjcf expect=error\n<m/>\n```\n");
  EXPECT_NE(refused.find("<samp>line 1: no &lt;mujoco&gt;\n</samp>"), std::string::npos) << refused;
}

// The page of a quiz with one question.
std::string quiz(const std::string& question) {
  return "```quiz\n{\"id\": \"q.1\", \"questions\": [" + question + "]}\n```\n";
}

void expect_in(const std::string& html, const std::string& part) {
  EXPECT_NE(html.find(part), std::string::npos) << "no " << part << "\n" << html;
}

TEST_F(PageWriterTest, SaysHowFarANumberMayBeOff) {
  const std::string percent =
      body(quiz(R"({"kind": "numeric", "q": "?", "answer": -40, "tol": "2.5%", "unit": "N"})"));
  expect_in(percent, "data-kind=\"numeric\" data-key=\"-40\" data-tolerance=\"1\"");
  expect_in(percent, ">Your answer, to within 2.5\u00a0%</label>");
  expect_in(body(quiz(R"({"kind": "numeric", "q": "?", "answer": 4, "tol": 0.5, "unit": "N"})")),
            ">Your answer, to within 0.5\u00a0N</label>");
  expect_in(body(quiz(R"({"kind": "numeric", "q": "?", "answer": 4})")), ">Your answer</label>");
}

TEST_F(PageWriterTest, KeepsAllDigitsOfAnAnswer) {
  for (const std::string answer : {"123456789012", "0.12345678901234", "0.1", "1e-19"}) {
    const std::string page =
        body(quiz(R"({"kind": "numeric", "q": "?", "answer": )" + answer + "}"));
    expect_in(page, "data-key=\"" + answer + "\"");
    expect_in(page, ">" + answer + "<");
  }
}

TEST_F(PageWriterTest, KeepsWhatThereIsToSayOfAnOptionInTheAnswer) {
  const std::string html = body(quiz(R"({"kind": "multi", "q": "?", "answer": [2, 0], "hint": "*h*",
    "options": ["a", {"text": "b", "feedback": "No `b`."}, "c"]})"));
  expect_in(html, "data-key=\"A C\"");
  expect_in(html, "<p class=\"right\"><strong>A. a</strong></p>");
  expect_in(html, "<p class=\"right\"><strong>C. c</strong></p>");
  expect_in(html, "<div><p><em>h</em></p>\n</div>");
  expect_in(html,
            "<li data-option=\"B\"><span class=\"letter\">B</span> <div><p>No <code>b</code>.");
  EXPECT_EQ(html.find("data-option=\"A\""), std::string::npos) << html;
}

TEST_F(PageWriterTest, MixesTheItemsOfAnOrder) {
  const std::string html = body(quiz(R"({"kind": "order", "q": "?", "items": ["a", "b", "*c*"]})"));
  expect_in(html, "data-key=\"B A C\"");
  expect_in(html, "data-letter=\"A\"><span class=\"item\" id=\"quiz-q-1-1-A-text\">b</span></li>");
  expect_in(html, "data-letter=\"B\"><span class=\"item\" id=\"quiz-q-1-1-B-text\">a</span></li>");
  expect_in(html, "<ol class=\"right\">\n<li>a</li>\n<li>b</li>\n<li><em>c</em></li>\n</ol>");
}

TEST_F(PageWriterTest, KeepsCodeWithAHyphenOnOneLine) {
  EXPECT_EQ(body("`data->qpos`, `qpos` and `a long command with --an-option`\n"),
            "<p><code class=\"whole\">data-&gt;qpos</code>, <code>qpos</code> and "
            "<code>a long command with --an-option</code></p>\n");
}

TEST(SiteTemplates, AreOfABoundedSize) {
  const MemoryFiles assets({{"templates/page.hbs", std::string((256 << 10) + 1, 'a')}});
  try {
    site_templates(assets);
    FAIL() << "it was compiled";
  } catch (const BrokenTemplate& broken) {
    EXPECT_EQ(broken.error().name, "page");
    EXPECT_EQ(broken.error().message, "is larger than 256 KiB");
    EXPECT_EQ(broken.error().cure,
              "put parts of it into templates of their own, and what is no template into a file");
  }
}

}  // namespace
}  // namespace mjcourse
