#include "lesson/blocks/fence.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "reading_of.h"

namespace mjcourse {
namespace {

TEST(Fence, IsAProgram) {
  const ReadingOf reading =
      reading_of("```cpp file=\"examples/a b.cpp\" timeout=0.5\nint main() {}\n```\n");
  EXPECT_EQ(reading.mistakes(), "");
  const auto& example = reading.only<Example>();
  EXPECT_EQ(example.file.text, "examples/a b.cpp");
  EXPECT_EQ(example.name(), "a b");
  EXPECT_EQ(example.code.text, "int main() {}\n");
  EXPECT_EQ(example.seconds, 0.5);
}

TEST(Fence, MayBeEmpty) {
  const ReadingOf reading = reading_of("```cpp file=examples/a.cpp\n```\n");
  EXPECT_EQ(reading.mistakes(), "");
  EXPECT_EQ(reading.only<Example>().code.text, "");
}

TEST(Fence, KnowsWhereEachByteOfItsBodyStood) {
  const ReadingOf reading =
      reading_of("> - ```cpp file=examples/a.cpp\n>   é;\n>\n>     x;\n>   ```\n");
  const LocatedText& code = reading.only<Example>().code;
  EXPECT_EQ(code.text, "é;\n\n  x;\n");
  EXPECT_EQ(reading.place(code, 0), "5:5");
  EXPECT_EQ(reading.place(code, 2), "5:6");
  EXPECT_EQ(reading.place(code, 7), "7:7");
}

TEST(Fence, KnowsItsPlacesInAFileFromWindows) {
  const ReadingOf reading = reading_of_file(
      "---\r\ntitle: T\r\n---\r\n> ```cpp file=examples/a.cpp\r\n>   x;\r\n> ```\r\n");
  EXPECT_EQ(reading.mistakes(), "");
  EXPECT_EQ(reading.only<Example>().code.text, "  x;\n");
  EXPECT_EQ(reading.place(reading.only<Example>().code, 2), "5:5");
}

TEST(Fence, ClosesWithAsManyMarksAsItOpened) {
  EXPECT_EQ(reading_of("````cpp file=examples/a.cpp\n```\n````\n").only<Example>().code.text,
            "```\n");
  EXPECT_EQ(reading_of("~~~cpp file=examples/a.cpp\n```\n~~~\n").only<Example>().code.text,
            "```\n");
}

TEST(Fence, MustBeClosed) {
  EXPECT_EQ(mistakes_in("text\n\n```cpp file=examples/a.cpp\nint x;\n"),
            R"(content/1-a/1.1-x.md:6:1: error: this fence is never closed [E-fence-unclosed]
  6 | ```cpp file=examples/a.cpp
    | ^~~~~~~~~~~~~~~~~~~~~~~~~~
  cure: end it with a line of as many backticks
)");
}

TEST(Fence, IsNotClosedByTheEndOfItsQuote) {
  EXPECT_EQ(mistakes_in("> ```quiz\n> {}\n\nafter\n"),
            R"(content/1-a/1.1-x.md:4:3: error: this fence is never closed [E-fence-unclosed]
  4 | > ```quiz
    |   ^~~~~~~
  cure: end it with a line of as many backticks
)");
}

TEST(Fence, MustSayWhatItHolds) {
  EXPECT_EQ(mistakes_in("```\nx\n```\n"),
            R"(content/1-a/1.1-x.md:4:1: error: this fence does not say what it holds [E-fence-kind]
  4 | ```
    | ^~~
  cure: known: cpp, sh, xml, text, io, lab, quiz, figure, plot, demo, cmake, python, …
)");
  EXPECT_EQ(
      mistakes_in("    int x;\n"),
      R"(content/1-a/1.1-x.md:4:1: error: an indented block is code that nobody ran [E-fence-kind]
  4 |     int x;
    | ^~~~~~~~~~
  cure: remove the indentation, or use a fence
)");
}

TEST(Fence, SuggestsTheKindThatWasMeant) {
  EXPECT_EQ(mistakes_in("```quizz\n{}\n```\n"),
            R"(content/1-a/1.1-x.md:4:4: error: there is no fence `quizz` [E-fence-kind]
  4 | ```quizz
    |    ^~~~~
  cure: did you mean `quiz`?
)");
  EXPECT_EQ(mistakes_in("```lab\n{}\n```\n"),
            R"(content/1-a/1.1-x.md:4:1: error: a lab says of which kind it is [E-fence-kind]
  4 | ```lab
    | ^~~~~~
  cure: write `lab simlab`
)");
}

TEST(Fence, SuggestsTheSecondWordThatWasMeant) {
  const auto misspelt = [](const std::string& first, const std::string& second,
                           const std::string& cure) {
    const std::string column = std::to_string(first.size() + 5);
    return "content/1-a/1.1-x.md:4:" + column + ": error: there is no fence `" + first + " " +
           second + "` [E-fence-kind]\n  4 | ```" + first + " " + second + "\n    |" +
           std::string(first.size() + 5, ' ') + "^" + std::string(second.size() - 1, '~') +
           "\n  cure: " + cure + "\n";
  };
  EXPECT_EQ(mistakes_in("```lab simlb\n{}\n```\n"),
            misspelt("lab", "simlb", "did you mean `simlab`?"));
  EXPECT_EQ(mistakes_in("```cpp snipet\nint x;\n```\n"),
            misspelt("cpp", "snipet", "did you mean `snippet`?"));
  EXPECT_EQ(mistakes_in("```xml mjfc\n<mujoco/>\n```\n"),
            misspelt("xml", "mjfc", "did you mean `mjcf`?"));
  EXPECT_EQ(mistakes_in("```sh rnu\nls\n```\n"), misspelt("sh", "rnu", "did you mean `run`?"));
  EXPECT_EQ(mistakes_in("```python uncheckd\n1\n```\n"),
            misspelt("python", "uncheckd", "did you mean `unchecked`?"));
}

TEST(Fence, RefusesOptionsThatNobodyKnows) {
  EXPECT_EQ(
      mistakes_in("```cpp file=examples/a.cpp tiemout=2\n```\n"),
      R"(content/1-a/1.1-x.md:4:28: error: a `cpp` fence has no option `tiemout` [E-fence-option]
  4 | ```cpp file=examples/a.cpp tiemout=2
    |                            ^~~~~~~
  cure: did you mean `timeout`?
)");
  EXPECT_EQ(mistakes_in("```io wide\nINPUT: a\n```\n"),
            R"(content/1-a/1.1-x.md:4:7: error: a `io` fence has no option `wide` [E-fence-option]
  4 | ```io wide
    |       ^~~~
)");
}

TEST(Fence, RefusesATimeoutThatIsNoTime) {
  for (const std::string value : {"-1", "soon", "5s", "601", "inf", ""}) {
    const std::string fence = "```cpp file=examples/a.cpp timeout=" + value;
    const std::string marks = value.empty() ? "" : std::string(value.size() - 1, '~');
    EXPECT_EQ(mistakes_in(fence + "\n```\n"),
              "content/1-a/1.1-x.md:4:36: error: `timeout` must be a number, not less than 0 and "
              "not more than 600 "
              "[E-fence-option]\n"
              "  4 | " +
                  fence + "\n    |" + std::string(36, ' ') + "^" + marks + "\n");
  }
}

TEST(Fence, RefusesAProgramThatNobodyRan) {
  EXPECT_EQ(
      mistakes_in("```cpp\nint x;\n```\n"),
      R"(content/1-a/1.1-x.md:4:1: error: a plain `cpp` fence would show code that nobody ran [E-fence-kind]
  4 | ```cpp
    | ^~~~~~
  cure: name the program's file: `cpp file=examples/NAME.cpp`; or let it be the body of a function: `cpp snippet model=NAME`; or say that nobody runs it, and why: `cpp unchecked because="…"`
)");
}

TEST(Fence, KeepsExamplesInTheirFolder) {
  const std::pair<std::string, std::string> wrong[] = {
      {"other/a.cpp", ""},
      {"examples/a.py", ""},
      {"examples/../a.cpp", ", and `..` is the folder above"},
      {"examples//a.cpp", ", and `` is no name"},
      {"examples/.a.cpp", ", and `.a.cpp` begins with a dot, so it is hidden"},
      {"examples/a:b.cpp", ", and `a:b.cpp` has a `:` in it, which no name on Windows has"},
      {"examples/con.cpp", ", and `con.cpp` is a device on Windows"}};
  for (const auto& [file, why] : wrong) {
    const std::string cure =
        why.empty() ? "" : "  cure: give the file a name of letters, digits, `-`, `_` and dots\n";
    const std::string marked = "^" + std::string(file.size() - 1, '~') + "\n" + cure;
    const auto said = [&marked, &why = why](const std::string& what, std::size_t column,
                                            const std::string& opened) {
      return "content/1-a/1.1-x.md:4:" + std::to_string(column) + ": error: " + what +
             " is a file `examples/NAME.cpp`" + why + " [E-example-file]\n  4 | " + opened +
             "\n    | " + std::string(column - 1, ' ') + marked;
    };
    const std::string plain = "```cpp file=" + file;
    EXPECT_EQ(mistakes_in(plain + "\n```\n"), said("an example", 13, plain));
    const std::string exercise = "```cpp exercise file=" + file + "#x";
    EXPECT_EQ(mistakes_in(exercise + "\n```\n"), said("an exercise", 22, exercise));
    const std::string hidden = "```cpp exercise file=examples/a.cpp#x hidden=" + file;
    EXPECT_EQ(mistakes_in(hidden + "\n```\n"), said("a program of hidden checks", 46, hidden));
  }
}

}  // namespace
}  // namespace mjcourse
