#include "page/html/page_fonts.h"

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

namespace mjcourse {
namespace {

using Fonts = std::vector<std::string_view>;

std::string formula(const std::string& inside) {
  return "<p><span class=\"katex\">" + inside + "</span></p>";
}

TEST(PageFonts, AreThoseOfTextEverywhereAndOfWhatIsSlanted) {
  EXPECT_EQ(page_fonts("<p>Text</p>"), (Fonts{"serif.woff2", "sans.woff2"}));
  for (const std::string slanted :
       {"<header class=\"lesson-head\"><p class=\"summary\">A lesson</p></header>",
        "<p>is <em>not</em></p>"}) {
    EXPECT_EQ(page_fonts(slanted), (Fonts{"serif.woff2", "sans.woff2", "italic.woff2"}));
  }
}

TEST(PageFonts, OfALabsNoteHaveNoSerifs) {
  const std::string note = "<div class=\"lab-note\"><p>Pull <em>up</em></p></div>";
  const std::string plain = "<div class=\"lab-note\"><p>Pull</p></div><p>is <em>not</em></p>";
  EXPECT_EQ(page_fonts(note),
            (Fonts{"serif.woff2", "sans.woff2", "italic.woff2", "sans-italic.woff2"}));
  EXPECT_EQ(page_fonts(plain), (Fonts{"serif.woff2", "sans.woff2", "italic.woff2"}));
}

TEST(PageFonts, AreThoseOfCodeWhereSomeIs) {
  EXPECT_EQ(page_fonts("<p><code>mj_step</code></p>"),
            (Fonts{"serif.woff2", "sans.woff2", "mono.woff2"}));
}

TEST(PageFonts, OfAFormulaAreTakenFromWhatItsElementsBeginWith) {
  const std::string body = formula(
      "<span class=\"mord mathnormal s3\">α</span><span class=\"mord mathbf\">1</span>"
      "<span class=\"mord mathnormal\">q</span><span class=\"mord boldsymbol\">τ</span>"
      "<span class=\"mop op-symbol large-op\">∑</span>");
  EXPECT_EQ(page_fonts(body), (Fonts{"serif.woff2", "sans.woff2", "formula.woff2", "letters.woff2",
                                     "greek.woff2", "bold-greek.woff2", "larger.woff2"}));
}

TEST(PageFonts, AreEachThereOnce) {
  const std::string body = formula(
      "<span class=\"mop op-symbol small-op\">∫</span><span class=\"delimsizing size1\">(</span>");
  EXPECT_EQ(page_fonts(body), (Fonts{"serif.woff2", "sans.woff2", "formula.woff2", "large.woff2"}));
}

TEST(PageFonts, OfWhatIsFoldedOrForPaperAreNone) {
  const std::string body =
      "<details><summary>Hint</summary><details><code>a</code></details><code>b</code></details>"
      "<section class=\"answers\"><code>c</code></section>";
  EXPECT_EQ(page_fonts(body), (Fonts{"serif.woff2", "sans.woff2"}));
  EXPECT_EQ(page_fonts("<details><code>a</code></details><code>b</code>"),
            (Fonts{"serif.woff2", "sans.woff2", "mono.woff2"}));
  EXPECT_EQ(page_fonts("<details open><code>a</code></details>"),
            (Fonts{"serif.woff2", "sans.woff2", "mono.woff2"}));
  EXPECT_EQ(page_fonts("<details><code>a</code>"), (Fonts{"serif.woff2", "sans.woff2"}));
}

TEST(PageFonts, OfATagThatNeverEndsAreNone) {
  EXPECT_EQ(page_fonts("<span class=\"katex\"><span class=\"mord mathnormal\""),
            (Fonts{"serif.woff2", "sans.woff2", "formula.woff2"}));
}

}  // namespace
}  // namespace mjcourse
