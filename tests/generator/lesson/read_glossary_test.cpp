#include "lesson/read_glossary.h"

#include <gtest/gtest.h>

#include "reading_of.h"

namespace mjcourse {
namespace {

constexpr const char* kFront = "---\ntitle: Words\nsummary: All of them.\n---\n";

struct GlossaryOf {
  explicit GlossaryOf(const std::string& body)
      : glossary(read_glossary(kFront + body, diagnostics)) {}
  std::string mistakes() const { return shown(diagnostics); }

  Diagnostics diagnostics;
  std::optional<Glossary> glossary;
};

TEST(Glossary, HasATermForEachHeading) {
  const GlossaryOf read("Hello.\n\n## `qpos`\n\nOne.\n\n- Two.\n\n## Free joint\n\nThree $x$.\n");
  EXPECT_EQ(read.mistakes(), "");
  ASSERT_EQ(read.glossary->terms.size(), 2U);
  const Glossary::Term& first = read.glossary->terms[0];
  EXPECT_EQ(first.name + " " + first.id + " " + plain_text(first.definition.get()),
            "qpos qpos One.Two.");
  EXPECT_EQ(plain_text(read.glossary->page.document.get()), "Hello.");
  EXPECT_EQ(read.glossary->page.front.title.text, "Words");
  ASSERT_NE(read.glossary->find("free joint"), nullptr);
  EXPECT_EQ(read.glossary->find("free joint")->id, "free-joint");
  EXPECT_EQ(read.glossary->find("Free joint"), nullptr);  // keys are in small letters
}

TEST(Glossary, DefinesEachTermOnce) {
  EXPECT_EQ(GlossaryOf("## Hinge\n\nA.\n\n## HINGE\n\nB.\n").mistakes(),
            R"(content/glossary.md:9:1: error: `HINGE` is defined twice [E-term-twice]
  9 | ## HINGE
    | ^~~~~~~~
  cure: it was defined as `Hinge` above: make one of the two
)");
}

TEST(Glossary, MustHaveTermsAndTheirDefinitions) {
  EXPECT_EQ(GlossaryOf("Hello.\n").mistakes(),
            R"(content/glossary.md:1:1: error: this glossary has no terms [E-glossary-empty]
  1 | ---
    | ^~~
  cure: begin each with a heading, `## Free joint`, and define it below
)");
  EXPECT_EQ(GlossaryOf("## A\n\n## B\n\nText.\n").mistakes(),
            R"(content/glossary.md:5:1: error: `A` has no definition [E-glossary-definition]
  5 | ## A
    | ^~~~
  cure: say below its heading what it is
)");
}

TEST(Glossary, IsNotReadWithoutFrontMatter) {
  Diagnostics diagnostics;
  EXPECT_FALSE(read_glossary("## A\n\nText.\n", diagnostics).has_value());
  EXPECT_FALSE(read_glossary("---\ntitle: \xff\n---\n", diagnostics).has_value());
  ASSERT_EQ(diagnostics.size(), 2U);
  EXPECT_EQ(diagnostics[0].id + " " + diagnostics[1].id, "E-front-matter E-not-utf8");
}

}  // namespace
}  // namespace mjcourse
