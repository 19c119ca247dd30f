#include "lesson/blocks/read_code.h"

#include <gtest/gtest.h>

#include "reading_of.h"

namespace mjcourse {
namespace {

Example example(const std::string& options) {
  const ReadingOf reading = reading_of("```cpp file=examples/a.cpp" + options + "\n```\n");
  EXPECT_EQ(reading.mistakes(), "");
  return reading.only<Example>();
}

TEST(ReadCode, RunsAProgramPlainly) {
  const Example plain = example("");
  EXPECT_EQ(plain.exit_code, 0);
  EXPECT_TRUE(plain.compiles);
  EXPECT_FALSE(plain.optimize);
  EXPECT_TRUE(plain.arguments.empty());
  EXPECT_FALSE(plain.region);
}

TEST(ReadCode, TakesWhatAProgramIsExpectedToDo) {
  EXPECT_EQ(example(" expect=exit:3").exit_code, 3);
  EXPECT_EQ(example(" expect=exit:255").exit_code, 255);
  EXPECT_FALSE(example(" expect=compile-error").compiles);
}

TEST(ReadCode, TakesHowAProgramIsRun) {
  const Example run = example(" optimize timeout=30 args=\"a  --b=1\"");
  EXPECT_TRUE(run.optimize);
  EXPECT_EQ(run.seconds, 30);
  EXPECT_EQ(run.arguments, (std::vector<std::string>{"a", "--b=1"}));
}

TEST(ReadCode, TakesWhyNoPageRunsAProgram) {
  EXPECT_EQ(example("").native, "");
  EXPECT_EQ(example(" native").native, "native only");
  EXPECT_EQ(example(" native because=\"it measures\"").native, "it measures");
}

TEST(ReadCode, TakesARegion) {
  const ReadingOf reading = reading_of("```cpp file=examples/a.cpp#the-loop\nx;\n```\n");
  EXPECT_EQ(reading.mistakes(), "");
  const auto& region = reading.only<Example>();
  EXPECT_EQ(region.file.text, "examples/a.cpp");
  EXPECT_EQ(region.name(), "a");
  EXPECT_EQ(region.region.value().text, "the-loop");
  EXPECT_EQ(reading.place(*region.region), "4:28");
  EXPECT_EQ(region.code.text, "x;\n");
}

TEST(ReadCode, TakesAnExercise) {
  const ReadingOf reading = reading_of(
      "```cpp exercise file=examples/a.cpp#answer hidden=examples/b.cpp timeout=3\n```\n");
  EXPECT_EQ(reading.mistakes(), "");
  const auto& exercise = reading.only<Exercise>();
  EXPECT_EQ(exercise.program.file.text, "examples/a.cpp");
  EXPECT_EQ(exercise.program.region.value().text, "answer");
  EXPECT_EQ(exercise.program.seconds, 3);
  EXPECT_EQ(exercise.hidden.value().text, "examples/b.cpp");
}

TEST(ReadCode, HidesTheLinesOfASnippetThatSayIt) {
  const ReadingOf reading = reading_of(
      "```cpp snippet model=ball timeout=2\n//| int n = 2;\nuse(n);\n  //| }\n//|\n```\n");
  EXPECT_EQ(reading.mistakes(), "");
  const auto& snippet = reading.only<Snippet>();
  EXPECT_EQ(snippet.model.text, "ball");
  EXPECT_EQ(snippet.code.text, "    int n = 2;\nuse(n);\n      }\n   \n");
  EXPECT_EQ(snippet.shown, "use(n);\n");
  EXPECT_EQ(snippet.seconds, 2);
}

TEST(ReadCode, LetsASnippetSayWhyNoPageRunsIt) {
  EXPECT_EQ(reading_of("```cpp snippet model=ball native because=\"it measures\"\nx;\n```\n")
                .only<Snippet>()
                .native,
            "it measures");
  EXPECT_EQ(reading_of("```cpp snippet model=ball\nx;\n```\n").only<Snippet>().native, "");
}

TEST(ReadCode, LetsASnippetStateItsOutput) {
  const ReadingOf reading =
      reading_of("```cpp snippet model=ball\nx;\n```\n\nOutput:\n\n```text\n1\n```\n");
  EXPECT_EQ(reading.mistakes(), "");
  EXPECT_EQ(reading.only<Snippet>().outputs, std::vector<std::size_t>{1});
  EXPECT_EQ(reading.only<Output>().example, 0u);
}

// What is wrong with a fence with these words behind `cpp `.
std::string code_mistake(const std::string& words) {
  std::string text;
  for (const Diagnostic& found : reading_of("```cpp " + words + "\n```\n").diagnostics) {
    const auto start = static_cast<std::size_t>(found.place.column - 1);
    text += found.place.excerpt.substr(start, static_cast<std::size_t>(found.place.width)) + ": " +
            found.message + "; " + found.cure + "\n";
  }
  return text;
}

TEST(ReadCode, RefusesAnExpectationThatItDoesNotKnow) {
  EXPECT_EQ(code_mistake("file=examples/a.cpp expect=compile-eror"),
            "compile-eror: `expect` has no such value; did you mean `compile-error`?\n");
  EXPECT_EQ(code_mistake("file=examples/a.cpp expect=success"),
            "success: `expect` has no such value; known: exit:1, compile-error\n");
  for (const std::string code : {"exit:", "exit:256", "exit:-1", "exit:one"}) {
    EXPECT_EQ(code_mistake("file=examples/a.cpp expect=" + code),
              code +
                  ": an exit code is a whole number from 0 to 255; write it as "
                  "`expect=exit:1`\n");
  }
}

TEST(ReadCode, RefusesWordsThatItDoesNotKnow) {
  EXPECT_EQ(code_mistake("file=examples/a.cpp optimise"),
            "optimise: a `cpp` fence has no option `optimise`; did you mean `optimize`?\n");
  EXPECT_EQ(code_mistake("file=examples/a.cpp timeout"),
            "timeout: `timeout` needs a value; write `timeout=…`\n");
  EXPECT_EQ(code_mistake("file=examples/a.cpp optimize=1"),
            "optimize: `optimize` takes no value; write `optimize` alone\n");
  EXPECT_EQ(code_mistake("unchecked optimize"),
            "optimize: a `cpp unchecked` fence has no option `optimize`; known: because\n");
}

TEST(ReadCode, RefusesAReasonForNothing) {
  EXPECT_EQ(code_mistake("file=examples/a.cpp because=\"it measures\""),
            "it measures: this program has nothing to be excused; `native because=\"…\"` says why "
            "no page runs it\n");
}

TEST(ReadCode, RefusesASnippetOfNothing) {
  EXPECT_EQ(code_mistake("snippet"),
            "```cpp snippet: a snippet says which model it is about; write `cpp snippet "
            "model=NAME`\n");
  EXPECT_EQ(code_mistake("snippet model=ball"),
            "```cpp snippet model=ball: this snippet shows nothing; write a line that does not "
            "begin with `//| `\n");
}

TEST(ReadCode, RefusesToRunARegionInAWayOfItsOwn) {
  EXPECT_EQ(code_mistake("file=examples/a.cpp#main timeout=5"),
            "timeout: a `cpp` fence has no option `timeout`; known: file\n");
}

}  // namespace
}  // namespace mjcourse
