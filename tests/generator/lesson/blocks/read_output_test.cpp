// Which example an output belongs to.
#include <gtest/gtest.h>

#include "reading_of.h"

namespace mjcourse {
namespace {

const std::string kA = "```cpp file=examples/a.cpp\n```\n",
                  kB = "```cpp file=examples/b.cpp\n```\n";

// "a: 1" for each output: the example that it belongs to and its text.
std::string outputs(const std::string& body) {
  const ReadingOf reading = reading_of(body);
  std::string text = reading.mistakes();
  for (const Output* output : reading.all<Output>()) {
    const auto& example = std::get<Example>(reading.lesson->blocks[output->example]);
    text += example.name() + ": " + output->text.text;
  }
  return text;
}

TEST(Output, BelongsToTheExampleAboveIt) {
  EXPECT_EQ(outputs(kA + kB + "\n```text\n1\n```\n"), "b: 1\n");
}

TEST(Output, MayHaveALabelThatIsNotShown) {
  const ReadingOf reading = reading_of(kA + "\nOutput:\n\n```text\n1\n```\n");
  EXPECT_EQ(reading.mistakes(), "");
  EXPECT_EQ(reading.all<Output>().size(), 1u);
  EXPECT_EQ(reading.all<Shown>().size(), 1u);
  EXPECT_EQ(reading.only<Example>().outputs, std::vector<std::size_t>{1});
}

TEST(Output, MayNameItsExample) {
  EXPECT_EQ(outputs(kA + kB + "\nFar away.\n\n```text output=a\n1\n```\n"), "a: 1\n");
}

TEST(Output, BelongsToTheOneItNamesEvenRightAfterAnother) {
  EXPECT_EQ(outputs(kA + kB + "```text output=a\n1\n```\n"), "a: 1\n");
}

TEST(Output, MayGiveATolerance) {
  EXPECT_EQ(reading_of(kA + "```text tol=0.5\n1\n```\n").only<Output>().tolerance, 0.5);
  EXPECT_EQ(reading_of(kA + "```text\n1\n```\n").only<Output>().tolerance, std::nullopt);
}

TEST(Output, MustBelongToAnExample) {
  const std::string expected =
      R"(content/1-a/1.1-x.md:8:1: error: this output belongs to no program [E-output-stray]
  8 | ```text
    | ^~~~~~~
  cure: put it right after a `cpp file=…`, `cpp snippet` or `sh run` fence, or name the example above: `text output=NAME`
)";
  EXPECT_EQ(outputs(kA + "\nBetween.\n```text\n1\n```\n"), expected);
}

TEST(Output, MustNameAnExampleThatIsThere) {
  EXPECT_EQ(outputs(kA + "```text output=aa\n1\n```\n"),
            R"(content/1-a/1.1-x.md:6:16: error: there is no example `aa` above [E-output-stray]
  6 | ```text output=aa
    |                ^~
  cure: did you mean `a`?
)");
  EXPECT_EQ(outputs("```text output=a\n1\n```\n" + kA),
            R"(content/1-a/1.1-x.md:4:16: error: there is no example `a` above [E-output-stray]
  4 | ```text output=a
    |                ^
  cure: write its `cpp file=…` fence first
)");
}

}  // namespace
}  // namespace mjcourse
