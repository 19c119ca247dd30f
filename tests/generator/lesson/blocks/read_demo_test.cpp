#include <gtest/gtest.h>

#include "reading_of.h"

namespace mjcourse {
namespace {

TEST(Demo, HoldsAPieceOfTheLesson) {
  const ReadingOf reading = reading_of("````demo\nA $b$.\n\n```io\nINPUT: c\n```\n````\n");
  EXPECT_EQ(reading.mistakes(), "");
  EXPECT_EQ(reading.only<Demo>().source, "A $b$.\n\n```io\nINPUT: c\n```\n");
  EXPECT_EQ(plain_text(reading.only<Demo>().document.get()).substr(0, 4), "A b.");
  EXPECT_EQ(reading.only<Io>().rows.size(), 1u);
}

TEST(Demo, LeavesEverythingInItsPlace) {
  const ReadingOf reading =
      reading_of("$a$\n\n~~~demo\n$b$ and $b$\n\n> - `{m} c`\n>   $d$\n\n[e](1.1)\n~~~\n\n$f$\n");
  EXPECT_EQ(reading.mistakes(), "");
  std::string places;
  for (const Math* math : reading.all<Math>()) {
    places += math->tex.text + " " + reading.place(math->tex) + "\n";
  }
  EXPECT_EQ(places, "a 4:2\nb 7:2\nb 7:10\nd 10:6\nf 15:2\n");
  EXPECT_EQ(reading.place(reading.only<InlineValue>().expression), "9:10");
  EXPECT_EQ(reading.place(reading.lesson->links.at(0).target), "12:5");
}

TEST(Demo, ShowsAMistakeWhereItIs) {
  EXPECT_EQ(mistakes_in("Text.\n\n````demo\n```lab simlab\n{\"title\": \"T\", \"modle\": \"m\",\n"
                        " \"model\": \"m\", \"alt\": \"A\"}\n```\n````\n"),
            "content/1-a/1.1-x.md:8:17: error: a lab has no key \"modle\" [E-json-key]\n"
            "  8 | {\"title\": \"T\", \"modle\": \"m\",\n"
            "    |                 ^~~~~\n"
            "  cure: did you mean `model`?\n");
}

TEST(Demo, KeepsOutputsToItself) {
  const std::string program = "```cpp file=examples/a.cpp\n```\n";
  const ReadingOf inside = reading_of("````demo\n" + program + "\n```text\nx\n```\n````\n");
  EXPECT_EQ(inside.mistakes(), "");
  EXPECT_EQ(inside.only<Output>().example, 0u);
  EXPECT_EQ(
      underlined_mistakes(reading_of(program + "\n````demo\n```text\nx\n```\n````\n")),
      "E-output-stray <```text> this output belongs to no program | put it right after a `cpp "
      "file=…`, `cpp snippet` or `sh run` fence, or name the example above: `text output=NAME`\n");
}

TEST(Demo, HasHeadingsThatAreNotItsPages) {
  const ReadingOf reading = reading_of("## A\n````demo\n## A\n````\n## B\n");
  const std::vector<Heading>& headings = reading.lesson->headings;
  ASSERT_EQ(headings.size(), 3u);
  EXPECT_EQ(headings[1].id, "a-2");
  EXPECT_TRUE(headings[1].in_demo);
  EXPECT_FALSE(headings[0].in_demo || headings[2].in_demo);
}

TEST(Demo, SharesThePagesFootnotes) {
  EXPECT_EQ(
      underlined_mistakes(
          reading_of("a[^x]\n\n[^x]: One.\n\n````demo\nb[^x] c[^y]\n\n[^y]: Two.\n\n[^x]: "
                     "Three.\n````\n")),
      "E-footnote-name <[^x]> another footnote of this page is called `x` | give it a name of "
      "its own\n");
}

TEST(Demo, StandsByItself) {
  EXPECT_EQ(
      underlined_mistakes(reading_of("- ````demo\n  a\n  ````\n")),
      "E-demo-indented <````demo> a demo begins at the very start of its line | take it out of "
      "the list or the quote, or remove its indentation\n");
  EXPECT_EQ(underlined_mistakes(reading_of("`````demo\n````demo\na\n````\n`````\n")),
            "E-demo-nested <````demo> a demo cannot stand in a demo | put the two one after the "
            "other\n");
  EXPECT_EQ(underlined_mistakes(reading_of("````demo\n````\n")),
            "E-demo-empty <````demo> this demo shows nothing | put a piece of a lesson into it\n");
}

}  // namespace
}  // namespace mjcourse
