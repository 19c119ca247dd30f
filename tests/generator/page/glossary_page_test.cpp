#include "page/glossary_page.h"

#include "lesson/read_glossary.h"
#include "page/page_fixture.h"

namespace mjcourse {
namespace {

class GlossaryPageTest : public PageWriterTest {
 protected:
  GlossaryPageTest() {
    course_.add(std::move(reading_of("## One\n\nA [[Hinge]].\n").lesson.value()));
    course_.glossary = read_glossary(
        "---\ntitle: Words\n---\n## slide\n\nAlong `{zoo} model.nq`\nand $x$.\n\n## Hinge\n\nNot a "
        "[[slide]].\n",
        diagnostics_);
    evaluation_.lessons.resize(1);
    for (std::size_t i = 0; i < course_.glossary->page.blocks.size(); ++i) {
      const Block& block = course_.glossary->page.blocks[i];
      if (std::holds_alternative<InlineValue>(block)) {
        evaluation_.glossary.of_block[i] = ValueResult{"13", "model.nq of zoo.xml"};
      }
    }
  }

  Diagnostics diagnostics_;
  Evaluation evaluation_;
};

TEST_F(GlossaryPageTest, DefinitionsArePlainTextForTitles) {
  const auto definitions = plain_definitions(course_, evaluation_);
  EXPECT_EQ(definitions.at("slide"), "Along 13 and x.");
  EXPECT_EQ(definitions.at("hinge"), "Not a slide.");
}

TEST_F(GlossaryPageTest, HasTheTermsInOrderWithTheirUses) {
  const auto definitions = plain_definitions(course_, evaluation_);
  const std::string html =
      glossary_page(course_, evaluation_,
                    {*templates_, *highlighter_, manifest_, styles_, "glossary.html", &definitions},
                    script_bundle(DiskFiles(MJCOURSE_ASSETS), "collate"));
  EXPECT_LT(html.find("<h2 id=\"hinge\">"), html.find("<h2 id=\"slide\">"));
  EXPECT_NE(
      html.find("Not a <a class=\"term\" href=\"#slide\" title=\"Along 13 and x.\">slide</a>."),
      html.npos)
      << html;
  EXPECT_NE(
      html.find("<a href=\"1-a/1.1-x.html\">1.1 T</a>: <a href=\"1-a/1.1-x.html#one\">One</a>"),
      html.npos)
      << html;
}

TEST_F(GlossaryPageTest, IsLinkedToFromPagesInFolders) {
  const auto definitions = plain_definitions(course_, evaluation_);
  PageWriter writer(course_, course_.lessons[0], results_,
                    {*templates_, *highlighter_, manifest_, styles_, "", &definitions});
  EXPECT_NE(writer.body().find(
                "A <a class=\"term\" href=\"../glossary.html#hinge\" title=\"Not a slide.\">"
                "Hinge</a>."),
            std::string::npos);
}

}  // namespace
}  // namespace mjcourse
