#include "page/html/anchors.h"

#include <gtest/gtest.h>

#include "reading_of.h"

namespace mjcourse {
namespace {

TEST(Anchors, CanBeNamedByAnySelector) {
  EXPECT_EQ(as_id("1.2-check"), "1-2-check");
  EXPECT_EQ(as_id("a b_c:dé"), "a-b-c-d--");
}

TEST(Anchors, OfANameKeepWhatAddressesCanHave) {
  EXPECT_EQ(id_of_name("Größe_1.5/x"), "Größe_1.5/x");
  EXPECT_EQ(id_of_name("a b\t\"c\"#%&'<>?\\`d\x7F"), "a-b--c----------d-");
}

TEST(Anchors, AreTheLessonsNumberOrItsNameWithoutOne) {
  Lesson lesson;
  lesson.slug = "glossary";
  EXPECT_EQ(lesson_anchor(lesson), "lesson-glossary");
  lesson.number = "1.2";
  EXPECT_EQ(lesson_anchor(lesson), "lesson-1-2");
  EXPECT_EQ(claim_anchor(lesson, 16), "lesson-1-2-17");
}

// The anchor of a claim about the block `index`, in line `line` of a lesson of all kinds.
std::string anchor_of(std::size_t index, int line, std::size_t part = 0) {
  const ReadingOf reading = reading_of(R"(Before `{m} model.nq`.

## First

```cpp file=examples/say.cpp
int main() {}
```

```text
x
```

```cpp file=examples/say.cpp#part
int y;
```

```quiz
{"id": "1.1-check", "questions": [
  {"kind": "numeric", "q": "?", "answer": 1, "verify": [{"because": "it is"}]},
  {"kind": "numeric", "q": "!", "answer": 1, "verify": [{"because": "it is"}]}]}
```

```figure
{"model": "m", "alt": "A."}
```

## Second

`{m} model.nv`
)");
  EXPECT_EQ(reading.mistakes(), "");
  Claim claim;
  claim.block = index;
  claim.part = part;
  claim.place.line = line;
  return place_anchor(reading.lesson.value(), claim);
}

TEST(Anchors, LeadToWhatAClaimIsAbout) {
  EXPECT_EQ(anchor_of(1, 8), "example-say");
  EXPECT_EQ(anchor_of(2, 12), "example-say");  // an output stands below its program
  EXPECT_EQ(anchor_of(3, 16), "example-say-part");
  EXPECT_EQ(anchor_of(4, 22, 1), "quiz-1-1-check-2");
  EXPECT_EQ(anchor_of(5, 26), "figure-1");
}

TEST(Anchors, LeadToTheHeadingAboveWhatHasNone) {
  EXPECT_EQ(anchor_of(0, 4), "");
  EXPECT_EQ(anchor_of(6, 32), "second");
}

}  // namespace
}  // namespace mjcourse
