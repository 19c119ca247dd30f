#include "evaluate/programs/compile_errors.h"

#include <gtest/gtest.h>

#include "base/files.h"
#include "base/temporary_folder.h"
#include "reading_of.h"

namespace mjcourse {
namespace {

// A lesson whose example stands in a quote, so that the compiler's columns are not the lesson's.
class CompileErrors : public testing::Test {
 protected:
  Diagnostics diagnostics_of(std::vector<CompilerMessage> messages, const std::string& raw = "") {
    Compiled compiled;
    compiled.messages = std::move(messages);
    compiled.raw = raw;
    const auto& example = reading_.only<Example>();
    Diagnostics diagnostics;
    report_compile_messages(compiled, {example.code, kLessonPath, example.span, 5},
                            *reading_.lesson, course_.path(), diagnostics);
    return diagnostics;
  }
  // What a terminal shows of `messages` about the example.
  std::string report(std::vector<CompilerMessage> messages, const std::string& raw = "") {
    return shown(diagnostics_of(std::move(messages), raw));
  }

  const TemporaryFolder course_;
  const ReadingOf reading_ =
      reading_of("> ```cpp file=examples/a.cpp\n> int main() {\n>   é(undeclared);\n> }\n> ```\n");
  const CompilerMessage error_{kLessonPath, 6, 6, "error", "use of undeclared identifier"};
  const CompilerMessage in_header_{"/usr/include/Eigen/Core", 90, 3, "error", "static assertion"};
  const std::string at_fence_ =
      "  4 | > ```cpp file=examples/a.cpp\n"
      "    |   ^~~~~~~~~~~~~~~~~~~~~~~~~~\n";
};

TEST_F(CompileErrors, StandAtTheLessonsLineAndColumn) {
  EXPECT_EQ(report({error_}),
            R"(content/1-a/1.1-x.md:6:7: error: use of undeclared identifier [E-example-compile]
  6 | >   é(undeclared);
    |       ^~~~~~~~~~
)");
}

TEST_F(CompileErrors, MayBeWarnings) {
  CompilerMessage warning = error_;
  warning.severity = "warning";
  warning.text = "unused [-Wunused]";
  EXPECT_EQ(report({error_, warning}).substr(report({error_}).size()),
            R"(content/1-a/1.1-x.md:6:7: warning: unused [-Wunused] [W-example-compile]
  6 | >   é(undeclared);
    |       ^~~~~~~~~~
)");
}

// Not in a terminal alone: a report is JSON.
TEST_F(CompileErrors, AreTextWhateverTheyQuote) {
  CompilerMessage error = error_;
  error.text = "\xff\x1b[2J";
  EXPECT_EQ(diagnostics_of({error}).at(0).message, "�\\x1b[2J");
}

TEST_F(CompileErrors, SayThatThereIsNoReason) {
  CompilerMessage error = error_;
  error.text = "";
  EXPECT_EQ(report({error}),
            R"(content/1-a/1.1-x.md:6:7: error: the compiler gives no reason [E-example-compile]
  6 | >   é(undeclared);
    |       ^~~~~~~~~~
)");
}

TEST_F(CompileErrors, OfAHeaderStandAtTheLineThatCausedThem) {
  EXPECT_EQ(report({in_header_,
                    {"/usr/include/Eigen/Dense", 7, 1, "note", "in instantiation of 'Inner'"},
                    {kLessonPath, 5, 5, "note", "in instantiation of 'Outer' requested here"}}),
            R"(content/1-a/1.1-x.md:5:7: error: static assertion [E-example-compile]
  5 | > int main() {
    |       ^~~~
    in /usr/include/Eigen/Core:90
)");
}

TEST_F(CompileErrors, OfAHeaderThatNothingCausedStandAtTheFence) {
  const std::string expected =
      "content/1-a/1.1-x.md:4:3: error: static assertion [E-example-compile]\n" + at_fence_ +
      "    in /usr/include/Eigen/Core:90\n";
  EXPECT_EQ(report({in_header_}), expected);
  // The note behind another error belongs to that one.
  EXPECT_EQ(report({in_header_, error_, {kLessonPath, 5, 5, "note", "declared here"}}),
            expected + report({error_}));
}

TEST_F(CompileErrors, OfAHeaderOfTheCourseStandInTheHeader) {
  write_file(course_.path() / "examples/a n#1.h", "\nint é = undeclared;\n");
  const CompilerMessage in_own{(course_.path() / "examples/x/../a n#1.h").string(), 2, 10, "error",
                               "use of undeclared identifier"};
  EXPECT_EQ(report({in_own}),
            R"(examples/a n#1.h:2:9: error: use of undeclared identifier [E-example-compile]
  2 | int é = undeclared;
    |         ^~~~~~~~~~
  note: content/1-a/1.1-x.md:4:3: this program includes it
  4 | > ```cpp file=examples/a.cpp
    |   ^~~~~~~~~~~~~~~~~~~~~~~~~~
)");
  EXPECT_EQ(report({in_own, {kLessonPath, 5, 5, "note", "in instantiation requested here"}}),
            R"(content/1-a/1.1-x.md:5:7: error: use of undeclared identifier [E-example-compile]
  5 | > int main() {
    |       ^~~~
  note: examples/a n#1.h:2:9: the compiler finds it in this header
  2 | int é = undeclared;
    |         ^~~~~~~~~~
)");
}

TEST_F(CompileErrors, NameFilesAsTheCourseDoes) {
  CompilerMessage error = error_;
  error.text = "cannot open file '" + (course_.path() / "examples/../lib/n.h").string() +
               "': Permission denied";
  EXPECT_EQ(
      report({error}),
      R"(content/1-a/1.1-x.md:6:7: error: cannot open file 'examples/../lib/n.h': Permission denied [E-example-compile]
  6 | >   é(undeclared);
    |       ^~~~~~~~~~
  cure: a header of the course lies beside the program and is included as `"name.h"`, or in examples/include
)");
}

TEST_F(CompileErrors, AreCutAfterTheFirstFive) {
  const std::vector<CompilerMessage> seven(7, error_);
  const std::vector<CompilerMessage> five(5, error_);
  EXPECT_EQ(report(seven), report(five));
}

TEST_F(CompileErrors, OfTheLinkerAreSaidOnceAndWithoutTemporaryFiles) {
  EXPECT_EQ(report({},
                   "/usr/bin/ld: /tmp/a-1f.o: in function `main':\n"
                   "a.cpp:(.text+0x9): undefined reference to `lost()'\n"
                   "a.cpp:(.text+0xf): undefined reference to `lost()'\n"
                   "clang: error: linker command failed with exit code 1\n"),
            "content/1-a/1.1-x.md:4:3: error: the program does not link [E-example-compile]\n" +
                at_fence_ + "    undefined reference to `lost()'\n");
  EXPECT_EQ(report({}, "the compiler ran out of time"),
            "content/1-a/1.1-x.md:4:3: error: the program does not link [E-example-compile]\n" +
                at_fence_ + "    the compiler ran out of time\n");
}

TEST_F(CompileErrors, SurvivePlacesThatAreNotThere) {
  EXPECT_NE(report({{kLessonPath, 999, 999, "error", "far away"}}), "");
  EXPECT_NE(report({{kLessonPath, 0, 0, "error", "nowhere"}}), "");
}

// The example of an empty fence is compiled from its file, and its messages stand there.
TEST_F(CompileErrors, OfAFileStandInTheFile) {
  const LocatedText code{"int main() {\n  é(undeclared);\n}\n", {}};
  const Span fence = reading_.only<Example>().span;
  Compiled compiled;
  compiled.messages = {{"examples/a.cpp", 2, 6, "error", "use of undeclared identifier"}};
  Diagnostics diagnostics;
  report_compile_messages(compiled, {code, "examples/a.cpp", fence}, *reading_.lesson,
                          course_.path(), diagnostics);
  EXPECT_EQ(shown(diagnostics),
            R"(examples/a.cpp:2:5: error: use of undeclared identifier [E-example-compile]
  2 |   é(undeclared);
    |     ^~~~~~~~~~
  note: content/1-a/1.1-x.md:4:3: the lesson shows this file
  4 | > ```cpp file=examples/a.cpp
    |   ^~~~~~~~~~~~~~~~~~~~~~~~~~
)");
}

}  // namespace
}  // namespace mjcourse
