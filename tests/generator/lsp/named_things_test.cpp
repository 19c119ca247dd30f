#include "lsp/named_things.h"

#include <gtest/gtest.h>

#include "reading_of.h"

namespace mjcourse {
namespace {

// "model swing@5:3 …" of what the lesson names.
std::string named_in(const std::string& body) {
  const ReadingOf reading = reading_of(body);
  std::string all;
  for (const NamedThing& thing : named_things(reading.lesson.value())) {
    constexpr const char* kinds[] = {"model", "program", "file", "term", "link"};
    all += std::string(kinds[static_cast<int>(thing.kind)]) + " " + thing.name.text + "@" +
           reading.place(thing.name) + (thing.what.empty() ? "" : " " + thing.what) + "|";
  }
  return all;
}

// Whether it is a model's or a program's, only the course can say.
TEST(NamedThings, OfAValueMayBeAModelOrAProgram) {
  EXPECT_EQ(named_in("`{swing} model.nq`\n"), "model swing@4:3|program swing@4:3|");
}

TEST(NamedThings, AreTermsAndLinks) {
  EXPECT_EQ(named_in("A [[Hinge joint|hinge]], [there](1.2#end).\n"),
            "term Hinge joint@4:5 hinge joint|link 1.2#end@4:34|");
}

TEST(NamedThings, AreFilesAndTheirRegions) {
  EXPECT_EQ(named_in("```cpp file=examples/a.cpp\nint main() {}\n```\n\n"
                     "```cpp file=examples/a.cpp#part\nint x;\n```\n"),
            "file examples/a.cpp@4:13|file examples/a.cpp@8:13 part|");
}

TEST(NamedThings, AreTheModelsOfFences) {
  EXPECT_EQ(named_in("```cpp snippet model=swing\nmj_step(model, data);\n```\n\n"
                     "```xml model=cart\n<body/>\n```\n"),
            "model swing@4:22|model cart@8:14|");
}

TEST(NamedThings, AreThoseOfALabWithItsGoal) {
  EXPECT_EQ(named_in(R"(```lab simlab
{"title": "T", "model": "swing", "alt": "A swing.", "editable": true,
 "goal": {"text": "Do.", "done": "model.nq === 2", "solution": {"model": "double"}}}
```
)"),
            "model swing@5:26|model double@6:75|");
}

TEST(NamedThings, AreThoseOfFiguresAndPlots) {
  EXPECT_EQ(named_in(R"(```figure
{"alt": "A swing.", "model": "swing", "from": "record/end"}
```

```plot
{"alt": "A curve.", "data": {"name": "say/energy"}, "mark": "line"}
```
)"),
            "model swing@5:31|program record@5:48|program say@9:39|");
}

TEST(NamedThings, AreThoseOfEachProof) {
  EXPECT_EQ(named_in(R"(```quiz
{"id": "q", "questions": [{"kind": "numeric", "q": "How many?", "answer": 2, "verify": [
  {"model": "swing", "value": "model.nq"}, {"example": "say", "value": "nq"}]}]}
```
)"),
            "model swing@6:14|program say@6:57|");
}

// A model that is written out has no file to go to, and still a place.
TEST(NamedThings, AreNotWhatIsOnlyText) {
  EXPECT_EQ(named_in("## Heading\n\n$x$ and `code`.\n\n> [!note] Title\n> Text.\n"), "");
}

}  // namespace
}  // namespace mjcourse
