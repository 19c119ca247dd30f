#include "lesson/blocks/block_scripts.h"

#include <gtest/gtest.h>

#include <array>

#include "reading_of.h"

namespace mjcourse {
namespace {

// All scripts of a lesson's blocks, with spaces between them; values have `=` behind them, and
// those that can be set `:=`.
std::string scripts_in(const std::string& markdown) {
  const ReadingOf reading = reading_of(markdown);
  std::string text = reading.mistakes();
  for (const Block& block : reading.lesson.value().blocks) {
    for (const BlockScript& script : scripts_of(block)) {
      constexpr std::array kMarks{"", "=", ":="};
      text += (text.empty() ? "" : " ") + script.text->text +
              kMarks.at(static_cast<std::size_t>(script.kind));
    }
  }
  return text;
}

TEST(BlockScripts, AreThoseOfALab) {
  EXPECT_EQ(scripts_in(R"(```lab simlab
{"title": "T", "model": "m", "alt": "A", "controls": [
  {"type": "button", "label": "L", "run": "a"},
  {"type": "slider", "label": "L", "bind": "b", "min": 0, "max": 1},
  {"type": "toggle", "label": "L", "on": "c", "off": "d"},
  {"type": "select", "label": "L", "options": [{"label": "L", "run": "e"}, {"label": "M", "run": ""}]},
  {"type": "keyframe", "label": "L", "key": "home"}],
 "readouts": [{"label": "L", "expr": "f"}],
 "plots": [{"ylabel": "Y", "traces": [{"label": "L", "expr": "g"}]}],
 "predict": {"q": "Q", "run": "h", "value": "i", "seconds": 1, "tol": 1},
 "goal": {"text": "Q", "done": "j", "solution": {"run": "k"}},
 "ghost": {"label": "G", "run": "l"},
 "editable": {"tasks": [{"q": "Q", "value": "n", "tol": 1}]}}
```
)"),
            "a b:= c d e f= g= h i= j= k l n=");
}

TEST(BlockScripts, AreThoseOfAnswersFiguresAndValues) {
  EXPECT_EQ(scripts_in(R"(The value `{m} a`.

```figure
{"model": "m", "run": "b", "seconds": 1, "caption": "C", "alt": "A"}
```

```quiz
{"id": "q", "title": "T", "questions": [
  {"kind": "numeric", "q": "Q", "answer": 1,
   "verify": [{"model": "m", "run": "c", "value": "d"}, {"because": "so"}]},
  {"kind": "mcq", "q": "Q", "options": ["A", "B"], "answer": 0,
   "verify": [{"model": "m", "options": ["e", "f"]}]}]}
```
)"),
            "a= b c d= e= f=");
}

TEST(BlockScripts, AreNoneOfPrograms) {
  EXPECT_EQ(scripts_in("```cpp unchecked because=\"so\"\nint x;\n```\n\n$x$\n"), "");
}

}  // namespace
}  // namespace mjcourse
