#include "lesson/front_matter.h"

#include <gtest/gtest.h>

#include "reading_of.h"

namespace mjcourse {
namespace {

ReadingOf front(const std::string& yaml) {
  return reading_of_file("---\n" + yaml + "---\n\nText\n");
}

TEST(FrontMatter, SaysWhatALessonIs) {
  const ReadingOf reading = front(R"yaml(title: A title
summary: "With $x$ and [a link](1.2)"
minutes: 25
prerequisites: [1.1, "1.10"]
objectives:
  - Say *why*
  - 'Say $y$'
tags: [a, b]
draft: true
)yaml");
  EXPECT_EQ(reading.mistakes(), "");
  const FrontMatter& found = reading.lesson->front;
  EXPECT_EQ(found.title.text, "A title");
  EXPECT_EQ(plain_text(found.summary.get()), "With x and a link");
  EXPECT_EQ(found.minutes, 25);
  EXPECT_EQ(found.prerequisites[1].text, "1.10");
  EXPECT_EQ(plain_text(found.objectives[0].get()), "Say why");
  EXPECT_EQ(found.tags, (std::vector<std::string>{"a", "b"}));
  EXPECT_TRUE(found.draft);
}

TEST(FrontMatter, KnowsWhereItsValuesStand) {
  const ReadingOf reading = front(R"yaml(title: T
summary: "With $x$ and [a link](1.2)"
prerequisites: [1.1, "1.10"]
objectives:
  - Say $y$
  - >
    folded $z$
)yaml");
  const auto math = reading.all<Math>();
  EXPECT_EQ(reading.place(math[0]->tex), "3:17");
  EXPECT_EQ(reading.place(reading.lesson->links[0].target), "3:33");
  EXPECT_EQ(reading.place(reading.lesson->front.prerequisites[0]), "4:17");
  EXPECT_EQ(reading.place(reading.lesson->front.prerequisites[1]), "4:23");
  EXPECT_EQ(reading.place(math[1]->tex), "6:10");
  EXPECT_EQ(reading.place(math[2]->tex), "7:5");  // of a folded value, where it begins
}

TEST(FrontMatter, MustBeThere) {
  const ReadingOf reading = reading_of_file("# A lesson\n");
  EXPECT_FALSE(reading.lesson);
  EXPECT_EQ(
      reading.mistakes(),
      R"(content/1-a/1.1-x.md:1:1: error: a lesson begins with its front matter [E-front-matter]
  1 | # A lesson
    | ^~~~~~~~~~
  cure: begin the file with `---`, `title: …`, `---`
)");
}

TEST(FrontMatter, MustBeClosed) {
  const ReadingOf reading = reading_of_file("---\ntitle: A\n\nText\n");
  EXPECT_FALSE(reading.lesson);
  EXPECT_EQ(
      reading.mistakes(),
      R"(content/1-a/1.1-x.md:1:1: error: the front matter that opens here is never closed [E-front-matter]
  1 | ---
    | ^~~
  cure: end it with a line `---`
)");
}

TEST(FrontMatter, FollowsNoByteOrderMark) {
  EXPECT_EQ(reading_of_file("\uFEFF---\ntitle: A\n---\n").mistakes(),
            "content/1-a/1.1-x.md:1:1: error: the file begins with a byte-order mark "
            "[E-front-matter]\n"
            "  1 | \uFEFF---\n"
            "    | ^\n"
            "  cure: save it as UTF-8 without one\n");
}

TEST(FrontMatter, NeedsATitle) {
  EXPECT_EQ(front("draft: no\n").mistakes(),
            R"(content/1-a/1.1-x.md:2:1: error: the front matter has no `title` [E-front-matter]
  2 | draft: no
    | ^
  cure: add a line `title: …`
)");
}

TEST(FrontMatter, MustBeAMapping) {
  const std::string mapping =
      "the front matter must be a mapping: `key: value` lines [E-front-matter]\n";
  EXPECT_EQ(front("- a\n").mistakes(),
            "content/1-a/1.1-x.md:2:1: error: " + mapping + "  2 | - a\n    | ^\n");
  EXPECT_EQ(front("").mistakes(),
            "content/1-a/1.1-x.md:2:1: error: " + mapping + "  2 | ---\n    | ^\n");
}

// "line:column message | cure" of each mistake.
std::string mistakes(const std::string& yaml) {
  std::string text;
  for (const Diagnostic& d : front("title: T\n" + yaml).diagnostics) {
    EXPECT_EQ(d.id, "E-front-matter");
    text += std::to_string(d.place.line) + ":" + std::to_string(d.place.column) + " " + d.message +
            (d.cure.empty() ? "" : " | " + d.cure) + "\n";
  }
  return text;
}

TEST(FrontMatter, RefusesValuesOfTheWrongType) {
  EXPECT_EQ(mistakes("prerequisites: 1.1\n"), "3:16 `prerequisites` must be a list: [a, b]\n");
  EXPECT_EQ(mistakes("tags: [[a]]\n"), "3:8 each of `tags` must be a plain value\n");
  EXPECT_EQ(mistakes("draft: perhaps\n"), "3:8 `draft` must be true or false\n");
  EXPECT_EQ(mistakes("summary: [a]\n"), "3:10 `summary` must be a text\n");
  EXPECT_EQ(mistakes("minutes: many\n"), "3:10 `minutes` must be a number\n");
  for (const std::string minutes : {"-1", "1.5", ".inf", "1e9"}) {
    EXPECT_EQ(mistakes("minutes: " + minutes + "\n"),
              "3:10 `minutes` must be a whole number, not less than 0\n");
  }
}

// To a reader of YAML, what is not there stands at whatever comes next.
TEST(FrontMatter, ShowsTheKeyThatHasNoValue) {
  EXPECT_EQ(mistakes("summary:\nminutes: 3\n"),
            "3:1 `summary` must be a text | write it after the colon\n");
  EXPECT_EQ(mistakes("tags:\n\n# end\n"),
            "3:1 `tags` must be a list: [a, b] | write it after the colon\n");
  EXPECT_EQ(front("title:\nminutes: 3\n").mistakes(),
            R"(content/1-a/1.1-x.md:2:1: error: `title` must be a text [E-front-matter]
  2 | title:
    | ^~~~~
  cure: write it after the colon
)");
}

TEST(FrontMatter, RefusesKeysThatItDoesNotKnow) {
  EXPECT_EQ(mistakes("sumary: a\n"),
            "3:1 the front matter has no key `sumary` | did you mean `summary`?\n");
  EXPECT_EQ(mistakes("title: again\n"), "3:1 the key `title` stands twice\n");
}

TEST(FrontMatter, SaysWhereItIsNotYaml) {
  EXPECT_EQ(
      mistakes("summary: A: b\n"),
      "3:11 the front matter is not YAML: illegal map value | quote a value that holds `: ` or "
      "starts with a special character\n");
  // yaml-cpp shows one byte of a character that has several.
  EXPECT_EQ(
      mistakes("summary: \"\\ü\"\n"),
      "3:13 the front matter is not YAML: unknown escape character: \uFFFD | quote a value that "
      "holds `: ` or starts with a special character\n");
}

// What a message quotes is one line, whatever it is.
TEST(FrontMatter, QuotesAKeyWithALineBreakInIt) {
  EXPECT_EQ(mistakes("\"a\\nb\\e\": 1\n").substr(0, 60),
            "3:1 the front matter has no key `a\\nb\\x1b` | known: title, s");
}

}  // namespace
}  // namespace mjcourse
