#include "lesson/syntax/source_cursor.h"

#include <gtest/gtest.h>

namespace mjcourse {
namespace {

// A cursor at the beginning of a text.
struct CursorIn {
  explicit CursorIn(const std::string& bytes)
      : source("a.md", bytes), text(located(source, {0, bytes.size()})), cursor{text} {}

  SourceText source;
  LocatedText text;
  SourceCursor cursor;
};

// Where each byte of what was found stands, and the end.
std::string places(const LocatedText& found) {
  std::string text;
  for (std::size_t i = 0; i < found.offsets.size(); ++i) {
    text += (text.empty() ? "" : " ") + std::to_string(found.offsets[i]);
  }
  return text;
}

TEST(SourceCursor, FindsTheSameTextOnceMore) {
  CursorIn text("$x$, $x$");
  EXPECT_EQ(places(text.cursor.find("$x$")), "0 1 2 3");
  EXPECT_EQ(text.cursor.at, 3U);
  EXPECT_EQ(places(text.cursor.find("$x$")), "5 6 7 8");
  EXPECT_EQ(text.cursor.at, 8U);
}

TEST(SourceCursor, FindsLinesOfAQuote) {
  CursorIn text("> ab\n> cd\n");
  EXPECT_EQ(places(text.cursor.find("ab\ncd")), "2 3 4 7 8 9");
  EXPECT_EQ(text.cursor.at, 9U);
}

TEST(SourceCursor, BlamesWhatIsNotThereOnItsOwnPlace) {
  CursorIn text("|a\\|b|");
  text.cursor.at = 1;
  const LocatedText found = text.cursor.find("a|b");
  EXPECT_EQ(found.text, "a|b");
  EXPECT_EQ(found.span().begin, 1U);
  EXPECT_EQ(text.cursor.at, 1U);
}

TEST(SourceCursor, PassesCodeAndNoWordLikeIt) {
  CursorIn text("a [[b]] `a`, c");
  text.cursor.pass_code("a");
  EXPECT_EQ(text.cursor.at, 10U);
  text.cursor.pass_code("c");  // which is no code
  EXPECT_EQ(text.cursor.at, 10U);
}

TEST(SourceCursor, PassesNoCodeOfAnotherParagraph) {
  CursorIn text("a\n\n`b`");
  text.cursor.pass_code("b");
  EXPECT_EQ(text.cursor.at, 0U);
}

}  // namespace
}  // namespace mjcourse
