#include "preview/sent_pages.h"

#include <gtest/gtest.h>

namespace mjcourse {
namespace {

TEST(SentPages, FindsAPageByItsHash) {
  SentPages pages;
  const std::string a = pages.keep("a"), b = pages.keep("b");
  EXPECT_NE(a, b);
  EXPECT_EQ(pages.find(a), "a");
  EXPECT_EQ(pages.find(b), "b");
  EXPECT_EQ(pages.find("another"), std::nullopt);
}

TEST(SentPages, ForgetsWhatWasNotSentForLongest) {
  SentPages pages;
  const std::string first = pages.keep("first"), second = pages.keep("second");
  for (int i = 0; i < 38; ++i) pages.keep(std::to_string(i));
  pages.keep("first");
  pages.keep("one more");
  EXPECT_EQ(pages.find(first), "first");
  EXPECT_EQ(pages.find(second), std::nullopt);
}

}  // namespace
}  // namespace mjcourse
