#include "course/quotation_marks.h"

#include <gtest/gtest.h>

namespace mjcourse {
namespace {

std::string marks(const std::string& tag) {
  const QuotationMarks found = quotation_marks(tag);
  return std::string(found.open) + "a " + std::string(found.inner_open) + "b" +
         std::string(found.inner_close) + std::string(found.close);
}

TEST(QuotationMarks, AreThoseOfTheLanguage) {
  EXPECT_EQ(marks("de"), "„a ‚b‘“");
  EXPECT_EQ(marks("fr"), "«\u202fa «\u202fb\u202f»\u202f»");
  EXPECT_EQ(marks("pl"), "„a «b»”");
  EXPECT_EQ(marks("ja"), "「a 『b』」");
  EXPECT_EQ(marks("sv"), "”a ’b’”");
  EXPECT_EQ(marks("nl"), "‘a ‘b’’");
}

TEST(QuotationMarks, AreEnglishWhereNoOthersAreKnown) {
  for (const char* tag : {"en", "en-GB", "pt", "tr", "ko", "mi", "x"}) {
    EXPECT_EQ(quotation_marks(tag), kEnglishMarks) << tag;
  }
}

TEST(QuotationMarks, DependOnScriptAndRegionWhereTheyDiffer) {
  EXPECT_EQ(marks("de-AT"), marks("de"));
  EXPECT_EQ(marks("de-Latn-CH-1996"), marks("de"));
  EXPECT_EQ(marks("fr-CH"), "«a ‹b›»");
  EXPECT_EQ(marks("FR-ca"), "«\u202fa ”b“\u202f»");
  EXPECT_EQ(marks("pt-PT"), "«a “b”»");
  EXPECT_EQ(quotation_marks("es-MX"), kEnglishMarks);
  EXPECT_EQ(quotation_marks("es-Latn-MX"), kEnglishMarks);
  EXPECT_EQ(marks("es-ES"), "«a “b”»");
  EXPECT_EQ(quotation_marks("zh-CN"), kEnglishMarks);
  EXPECT_EQ(marks("zh-TW"), marks("ja"));
  EXPECT_EQ(marks("zh-Hant-SG"), marks("ja"));
  EXPECT_EQ(quotation_marks("zh-Hans-TW"), kEnglishMarks);
}

}  // namespace
}  // namespace mjcourse
