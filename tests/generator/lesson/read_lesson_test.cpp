#include "lesson/read_lesson.h"

#include <gtest/gtest.h>

#include "reading_of.h"

namespace mjcourse {
namespace {

TEST(Lesson, TakesItsNumberFromItsFilesName) {
  const ReadingOf reading =
      reading_of_file("---\ntitle: T\n---", "content/1-state/1.12-generalized-coordinates.md");
  EXPECT_EQ(reading.lesson->folder, "1-state");
  EXPECT_EQ(reading.lesson->slug, "1.12-generalized-coordinates");
  EXPECT_EQ(reading.lesson->number, "1.12");
}

TEST(Lesson, OfAnAppendixHasALetter) {
  const ReadingOf reading = reading_of_file("---\ntitle: T\n---", "content/guide/B.12-text.md");
  EXPECT_EQ(reading.lesson->slug, "B.12-text");
  EXPECT_EQ(reading.lesson->number, "B.12");
}

TEST(Lesson, MustHaveANumber) {
  for (const std::string name :
       {"intro.md", "1-intro.md", "1.2.md", "1.2-.md", "a.1-x.md", "AB.1-x.md", "1A.1-x.md"}) {
    const ReadingOf reading = reading_of_file("---\ntitle: T\n---\n", "content/a/" + name);
    EXPECT_FALSE(reading.lesson);
    EXPECT_EQ(reading.mistakes(), "content/a/" + name +
                                      ": error: a lesson's file is named after its number, as "
                                      "`1.2-a-title.md` [E-lesson-name]\n"
                                      "  cure: rename the file; an appendix has a letter: "
                                      "`A.1-a-title.md`\n");
  }
}

TEST(Lesson, MustBeUtf8) {
  const ReadingOf reading = reading_of("Caf\xE9 and \xFF\n");
  EXPECT_FALSE(reading.lesson);
  EXPECT_EQ(reading.mistakes(),
            "content/1-a/1.1-x.md:4:4: error: byte 0xE9 is not UTF-8 [E-not-utf8]\n"
            "  4 | Caf\uFFFD and \uFFFD\n"
            "    |    ^\n"
            "  cure: save the file as UTF-8\n");
}

// cmark would make NUL another character, and see a line's end in a carriage return alone.
TEST(Lesson, HasNoControlCharacters) {
  const ReadingOf reading = reading_of(std::string("Text.\n\nA\tb\0\x1b and\tso on\n", 24));
  EXPECT_FALSE(reading.lesson);
  EXPECT_EQ(
      reading.mistakes(),
      "content/1-a/1.1-x.md:6:4: error: byte 0x00 is a control character, which no text holds "
      "[E-control-character]\n"
      "  6 | A b\\x00\\x1b and\\tso on\n"
      "    |    ^~\n"
      "  cure: remove it\n");
  EXPECT_EQ(
      reading_of("One\rTwo\r\n").mistakes(),
      "content/1-a/1.1-x.md:4:4: error: byte 0x0D is a control character, which no text holds "
      "[E-control-character]\n"
      "  4 | One\\rTwo\n"
      "    |    ^~\n"
      "  cure: end lines with a line feed, also after a carriage return\n");
}

TEST(Lesson, KnowsItsLinesInAFileFromWindows) {
  EXPECT_EQ(reading_of_file("---\r\ntitle: T\r\n---\r\nText\r\n\r\n> [!nte] x\r\n").mistakes(),
            R"(content/1-a/1.1-x.md:6:5: error: there is no callout `nte` [E-callout-kind]
  6 | > [!nte] x
    |     ^~~
  cure: did you mean `note`?
)");
}

std::string ids(const std::string& body) {
  const ReadingOf reading = reading_of(body);
  std::string text;
  for (const Heading& heading : reading.lesson->headings) {
    text += std::to_string(heading.level) + " " + heading.id + "\n";
  }
  return text;
}

TEST(Heading, HasAnIdOfItsOwn) {
  EXPECT_EQ(ids("## Why four numbers?\n### `qpos` & $q_w$ – É\n## ?!\n"),
            "2 why-four-numbers\n3 qpos-qw-é\n2 section\n");
  EXPECT_EQ(ids("## A\n## A\n## A 2\n## A\n> ## A\n"), "2 a\n2 a-2\n2 a-2-2\n2 a-3\n2 a-4\n");
}

TEST(Heading, IsNotTheLessonsTitle) {
  EXPECT_EQ(
      mistakes_in("text\n\n# One\n"),
      R"(content/1-a/1.1-x.md:6:1: error: a lesson's own headings begin at the second level (`##`) [E-heading-level]
  6 | # One
    | ^
  cure: the page's first heading is the `title` of the front matter
)");
}

TEST(Link, KnowsWhereItsTargetStands) {
  const ReadingOf reading = reading_of(
      "[one](1.3) and [**b** `c`](1.3#x \"title\")\n\n"
      "> [d][ref] <https://a.example>\n\n[ref]: 1.9\n");
  std::string links;
  for (const Link& link : reading.lesson->links) {
    links += link.target.text + " " + reading.place(link.target) + "\n";
  }
  EXPECT_EQ(links, "1.3 4:7\n1.3#x 4:28\n1.9 8:8\nhttps://a.example 6:13\n");
}

// The same word may stand before it, as another link's, a footnote's or mere text.
TEST(Link, HasItsTargetBehindItsText) {
  const ReadingOf reading = reading_of(
      "nope [^nope] and [y](nope), [1.9] [c](1.9)\n\nnope [q][r] and [r](nope)\n\n"
      "[^nope]: foot\n\n[r]: nope\n");
  std::string places;
  for (const Link& link : reading.lesson->links) {
    places += link.target.text + " " + reading.place(link.target) + "\n";
  }
  EXPECT_EQ(places, "nope 4:22\n1.9 4:39\nnope 10:6\nnope 6:21\n");
}

// A footnote stands at the tree's end, by its first mention, wherever it was written.
TEST(Footnote, LeavesEverythingInItsPlace) {
  const ReadingOf reading = reading_of(
      "[^b]: [b](1.2) `{m} b`\n\n[a](1.1)[^a] and [^b]\n\n> [^a]: $a$ and\n> [a](1.3).\n\n"
      "[b](1.4) $b$\n");
  EXPECT_EQ(reading.mistakes(), "");
  std::string places;
  for (const Link& link : reading.lesson->links) {
    places += link.target.text + " " + reading.place(link.target) + "\n";
  }
  for (const InlineValue* value : reading.all<InlineValue>()) {
    places += value->expression.text + " " + reading.place(value->expression) + "\n";
  }
  for (const Math* math : reading.all<Math>()) {
    places += math->tex.text + " " + reading.place(math->tex) + "\n";
  }
  EXPECT_EQ(places, "1.1 6:5\n1.4 11:5\n1.3 9:7\n1.2 4:11\nb 4:21\nb 11:11\na 8:10\n");
}

TEST(Lesson, ShowsAllItsMistakesInOneRun) {
  const ReadingOf reading = reading_of_file(R"(---
titel: T
---
> [!nte] a

```cpp
```

```lab simlab
{"title": "T", "model": "m", "alt": "A", "dok": true}
```

```quiz
{
```

# One
$$
)");
  std::string found;
  for (const Diagnostic& d : reading.diagnostics) {
    found += std::to_string(d.place.line) + " " + d.id + "\n";
  }
  EXPECT_EQ(found,
            "2 E-front-matter\n2 E-front-matter\n4 E-callout-kind\n6 E-fence-kind\n10 E-json-key\n"
            "15 E-json-syntax\n17 E-heading-level\n18 E-math-unclosed\n");
}

}  // namespace
}  // namespace mjcourse
