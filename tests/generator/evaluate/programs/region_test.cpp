#include "evaluate/programs/region.h"

#include <gtest/gtest.h>

#include "evaluate/evaluation_of.h"

namespace mjcourse {
namespace {

const std::string kRegionProgram = R"(#include <cstdio>
int main() {
  // #region loop
  for (int i = 0; i < 2; ++i) {
    // #region print
    std::printf("%d\n", i);
    // #endregion
  }
  // #endregion
}
)";

EvaluationOf lesson_of(const std::string& body, const std::string& program = kRegionProgram) {
  return EvaluationOf(body, {{"examples/a.cpp", program}});
}

std::string region_fence(const std::string& name, const std::string& code = "") {
  return "```cpp file=examples/a.cpp#" + name + "\n" + code + "```\n";
}

TEST(Region, IsShownWithoutItsIndentationAndTheMarksInIt) {
  const EvaluationOf found = lesson_of(region_fence("loop"));
  EXPECT_EQ(found.mistakes(), "");
  EXPECT_EQ(found.result<ExampleResult>().code,
            "for (int i = 0; i < 2; ++i) {\n  std::printf(\"%d\\n\", i);\n}\n");
  EXPECT_EQ(found.tally().programs, 1);
}

TEST(Region, MayStandInTheFenceWithAnyIndentation) {
  EXPECT_EQ(lesson_of(region_fence("print", "std::printf(\"%d\\n\", i);\n")).mistakes(), "");
  EXPECT_EQ(lesson_of(region_fence("print", "    std::printf(\"%d\\n\", i);\n")).mistakes(), "");
}

TEST(Region, RunsItsProgramOnce) {
  EXPECT_EQ(lesson_of(region_fence("loop") + region_fence("print")).tally().programs, 1);
  const EvaluationOf whole = lesson_of(region_fence("print") + "```cpp file=examples/a.cpp\n```\n");
  EXPECT_EQ(whole.mistakes(), "");
  EXPECT_EQ(whole.tally().programs, 1);
}

TEST(Region, MayStateItsProgramsOutput) {
  const EvaluationOf found = lesson_of(region_fence("print") + "```text\n0\n1\n```\n");
  EXPECT_EQ(found.mistakes(), "");
  EXPECT_EQ(found.tally().outputs, 1);
}

TEST(Region, MustBeInItsFile) {
  EXPECT_EQ(
      lesson_of(region_fence("lop")).mistakes(),
      R"(content/1-a/1.1-x.md:4:28: error: examples/a.cpp has no region `lop` [E-example-region]
  4 | ```cpp file=examples/a.cpp#lop
    |                            ^~~
  cure: did you mean `loop`?
)");
  EXPECT_EQ(
      lesson_of(region_fence("loop"), "int main() {}\n").mistakes(),
      R"(content/1-a/1.1-x.md:4:28: error: examples/a.cpp has no region `loop` [E-example-region]
  4 | ```cpp file=examples/a.cpp#loop
    |                            ^~~~
  cure: put it between lines `// #region NAME` and `// #endregion`
)");
}

TEST(Region, MustEndAndHoldSomething) {
  EXPECT_EQ(
      lesson_of(region_fence("a"), "// #region a\nint main() {}\n").mistakes(),
      R"(content/1-a/1.1-x.md:4:28: error: the region `a` of examples/a.cpp is never closed [E-example-region]
  4 | ```cpp file=examples/a.cpp#a
    |                            ^
  cure: end it with a line `// #endregion`
)");
  EXPECT_EQ(
      lesson_of(region_fence("a"), "// #region a\n// #endregion\nint main() {}\n").mistakes(),
      R"(content/1-a/1.1-x.md:4:28: error: the region `a` of examples/a.cpp is empty [E-example-region]
  4 | ```cpp file=examples/a.cpp#a
    |                            ^
)");
}

TEST(Region, MustBeTheSameTextInLessonAndFile) {
  EXPECT_EQ(
      lesson_of(region_fence("print", "std::printf(\"%i\\n\", i);\n")).mistakes(),
      R"(content/1-a/1.1-x.md:4:13: error: the fence and the region `print` of examples/a.cpp differ, first in line 1 [E-example-file]
  4 | ```cpp file=examples/a.cpp#print
    |             ^~~~~~~~~~~~~~
  note: content/1-a/1.1-x.md:5:1: the lesson has
  5 | std::printf("%i\n", i);
    | ^~~~~~~~~~~~~~~~~~~~~~~
  note: examples/a.cpp:6:1: the file has
  6 |     std::printf("%d\n", i);
    | ^~~~~~~~~~~~~~~~~~~~~~~~~~~
  cure: `mjcourse accept` writes the fence's lines into the file; or leave the fence empty
)");
}

TEST(Region, MarksAreNotShownOfAWholeProgramEither) {
  EXPECT_EQ(as_shown(kRegionProgram),
            "#include <cstdio>\nint main() {\n  for (int i = 0; i < 2; ++i) {\n"
            "    std::printf(\"%d\\n\", i);\n  }\n}\n");
}

}  // namespace
}  // namespace mjcourse
