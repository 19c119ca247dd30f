#include "lsp/markdown.h"

#include <gtest/gtest.h>

namespace mjcourse {
namespace {

TEST(MarkdownOfHovers, HasWordsThatStayWords) {
  EXPECT_EQ(escaped_for_markdown("a model with 1 joint"), "a model with 1 joint");
  EXPECT_EQ(escaped_for_markdown("![x](https://e.example)"), R"(\!\[x\]\(https\:\/\/e\.example\))");
  EXPECT_EQ(escaped_for_markdown("<img src=x> **Proved**"), R"(&lt;img src\=x\> \*\*Proved\*\*)");
  EXPECT_EQ(escaped_for_markdown("a\n# b"), R"(a\\n\# b)");
  EXPECT_EQ(escaped_for_markdown("naïve"), "naïve");
}

TEST(MarkdownOfHovers, HasCodeThatStaysCode) {
  EXPECT_EQ(code_for_markdown(""), "");
  EXPECT_EQ(code_for_markdown("model.nq"), "`model.nq`");
  EXPECT_EQ(code_for_markdown("a ` b `` c"), "``` a ` b `` c ```");
  EXPECT_EQ(code_for_markdown("`"), "`` ` ``");
  EXPECT_EQ(code_for_markdown("a\n\n[x](y)"), R"(`a\n\n[x](y)`)");
}

}  // namespace
}  // namespace mjcourse
