#include "lesson/blocks/callout.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "lesson/guide_table.h"
#include "reading_of.h"

namespace mjcourse {
namespace {

std::string title_of(const Callout& callout) {
  return callout.title ? plain_text(callout.title.get()) : "none";
}

TEST(Callout, TakesKindAndTitleOutOfTheQuote) {
  const ReadingOf reading = reading_of("> [!pitfall] Not *four* numbers\n> The body.\n");
  EXPECT_EQ(reading.mistakes(), "");
  EXPECT_EQ(reading.only<Callout>().kind, "pitfall");
  EXPECT_EQ(title_of(reading.only<Callout>()), "Not four numbers");
  EXPECT_FALSE(reading.only<Callout>().folded);
  EXPECT_EQ(plain_text(reading.lesson->document.get()), "The body.");
}

TEST(Callout, KnowsEveryKind) {
  for (const std::string& kind : callout_kinds()) {
    const ReadingOf reading = reading_of("> [!" + kind + "]\n> body\n");
    EXPECT_EQ(reading.mistakes(), "");
    EXPECT_EQ(reading.only<Callout>().kind, kind);
    EXPECT_EQ(title_of(reading.only<Callout>()), "none");
  }
}

TEST(Callout, HasItsKindsInTheGuidesTable) {
  std::vector<std::string> kinds = callout_kinds();
  std::sort(kinds.begin(), kinds.end());
  EXPECT_EQ(names_of(guide_table("A.2-text.md", "| kind | for | looks |")), kinds);
}

TEST(Callout, StartsFoldedWhenToldOrWhenItIsASolution) {
  EXPECT_TRUE(reading_of("> [!derivation]- Title\n> body\n").only<Callout>().folded);
  EXPECT_EQ(title_of(reading_of("> [!derivation]- Title\n").only<Callout>()), "Title");
  EXPECT_TRUE(reading_of("> [!solution] Title\n> body\n").only<Callout>().folded);
}

TEST(Callout, MayHaveMathInItsTitle) {
  const ReadingOf reading = reading_of("> [!note] $q_w$ of *$x$*\n> $y$\n");
  EXPECT_EQ(title_of(reading.only<Callout>()), "q_w of x");
  const auto math = reading.all<Math>();
  ASSERT_EQ(math.size(), 3u);
  EXPECT_EQ(reading.place(math[0]->tex), "4:12");
  EXPECT_EQ(reading.place(math[1]->tex), "4:22");
  EXPECT_EQ(reading.place(math[2]->tex), "5:4");
}

TEST(Callout, MayStandInAListAndInACallout) {
  const ReadingOf reading =
      reading_of("- item\n  > [!warning] Outer\n  > b\n  >\n  > > [!tip] Inner\n  > > c\n");
  ASSERT_EQ(reading.all<Callout>().size(), 2u);
  EXPECT_EQ(title_of(*reading.all<Callout>()[1]), "Inner");
}

TEST(Callout, IsNotAPlainQuote) {
  EXPECT_TRUE(reading_of("> quote\n\n>\n\n> ## heading\n").all<Callout>().empty());
}

TEST(Callout, MustBeOfAKnownKind) {
  const ReadingOf reading = reading_of("text\n\n> [!eatablished] Bad\n> body\n");
  EXPECT_EQ(reading.mistakes(),
            R"(content/1-a/1.1-x.md:6:5: error: there is no callout `eatablished` [E-callout-kind]
  6 | > [!eatablished] Bad
    |     ^~~~~~~~~~~
  cure: did you mean `established`?
)");
  EXPECT_TRUE(reading.all<Callout>().empty());
}

}  // namespace
}  // namespace mjcourse
