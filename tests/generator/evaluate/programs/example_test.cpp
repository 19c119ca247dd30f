#include "evaluate/programs/example.h"

#include <gtest/gtest.h>

#include "evaluate/evaluation_of.h"

namespace mjcourse {
namespace {

std::string fence(const std::string& code, const std::string& options = "") {
  return "```cpp file=examples/a.cpp" + options + "\n" + code + "```\n";
}

// A lesson whose example's file says the same as its fence; `more` stands below it.
EvaluationOf example(const std::string& code, const std::string& options = "",
                     const std::string& more = "") {
  return EvaluationOf(fence(code, options) + more, {{"examples/a.cpp", code}});
}

// What is wrong with the run of a program, from its message on: the fence is always the place.
std::string run_mistake(const std::string& code, const std::string& options = "") {
  std::string text = example(code, options).mistakes();
  const std::string place = "content/1-a/1.1-x.md:4:1: error: ";
  const std::string excerpt = "\n  4 | ```cpp file=examples/a.cpp" + options +
                              "\n    | ^~~~~~~~~~~~~~~~~~~~~~~~~~" +
                              std::string(options.size(), '~') + "\n";
  const std::size_t end = text.find(excerpt);
  if (!text.starts_with(place) || end == std::string::npos) return text;
  return text.substr(place.size(), end + 1 - place.size()) + text.substr(end + excerpt.size());
}

TEST(Example, IsCompiledAndRun) {
  const std::string code = "#include <cstdio>\nint main() { std::puts(\"hello\"); }\n";
  const EvaluationOf found = example(code);
  EXPECT_EQ(found.mistakes(), "");
  EXPECT_EQ(found.result<ExampleResult>().output, "hello\n");
  EXPECT_EQ(found.result<ExampleResult>().code, code);
  EXPECT_EQ(found.tally().programs, 1);
}

TEST(Example, ReadsNothingAndRunsInAnEmptyFolder) {
  EXPECT_EQ(
      example("#include <cstdio>\n#include <filesystem>\nint main() {\n"
              "  std::printf(\"%d %d\\n\", std::getchar(), std::filesystem::is_empty(\".\"));\n}\n")
          .result<ExampleResult>()
          .output,
      "-1 1\n");
}

// The C library's variant for processors with a fused multiply-add gives a 6 more at the end, and
// WebAssembly what stands here.
TEST(Example, RoundsTheSameOnAllProcessors) {
  EXPECT_EQ(
      example("#include <cmath>\n#include <cstdio>\n#include <cstdlib>\nint main() {\n"
              "  volatile double x = 0.0173 * 66;\n"
              "  std::printf(\"%s %.17g\\n\", std::getenv(\"GLIBC_TUNABLES\"), std::cos(x));\n}\n")
          .result<ExampleResult>()
          .output,
      "glibc.cpu.hwcaps=-FMA,-FMA4,-AVX2 0.4159582880456274\n");
}

TEST(Example, FindsTheCoursesModels) {
  EXPECT_EQ(example("#include <cstdio>\n#include <cstdlib>\n#include <fstream>\n#include <string>\n"
                    "int main() {\n  std::ifstream f(std::getenv(\"MJCOURSE_MODELS\") + "
                    "std::string(\"/ball.xml\"));\n  std::string line;\n  std::getline(f, line);\n"
                    "  std::puts(line.c_str());\n}\n")
                .result<ExampleResult>()
                .output,
            "<mujoco>\n");
}

TEST(Example, TellsWhatAReaderNeedsToBuildIt) {
  const std::string code =
      "#include \"mjcourse/mjcourse.hpp\"\nint main() { mjcourse::load_model(\"pair\"); }\n";
  const std::string mistakes_and_files = [&] {
    const EvaluationOf found(
        fence(code),
        {{"examples/a.cpp", code},
         {"examples/include/mjcourse/mjcourse.hpp",
          "#pragma once\n#include <mujoco/mujoco.h>\n#include <cstdlib>\n#include <string>\n"
          "namespace mjcourse {\ninline void load_model(const std::string& name) {\n"
          "  char error[100];\n  mj_deleteModel(mj_loadXML((std::getenv(\"MJCOURSE_MODELS\") + "
          "(\"/\" + name + \".xml\")).c_str(), nullptr, error, 100));\n}\n}\n"},
         {"examples/include/other.hpp", "#pragma once\n"},
         {"models/pair.xml", "<mujoco><include file=\"parts/arm.xml\"/></mujoco>\n"},
         {"models/parts/arm.xml", "<mujocoinclude><worldbody/></mujocoinclude>\n"}});
    std::string text = found.mistakes();
    for (const std::string& file : found.result<ExampleResult>().files) text += file + "\n";
    return text;
  }();
  EXPECT_EQ(mistakes_and_files,
            "examples/include/mjcourse/mjcourse.hpp\nmodels/pair.xml\nmodels/parts/arm.xml\n");
}

TEST(Example, MayBeShownFromItsFile) {
  const std::string code = "#include <cstdio>\nint main() { std::puts(\"file\"); }\n";
  const EvaluationOf found(fence(""), {{"examples/a.cpp", code}});
  EXPECT_EQ(found.result<ExampleResult>().output, "file\n");
  EXPECT_EQ(found.result<ExampleResult>().code, code);
}

TEST(Example, MustBeTheSameTextInLessonAndFile) {
  EXPECT_EQ(
      evaluated_mistakes(fence("int main() {\n}\n"), {{"examples/a.cpp", "int main() {\n\n}\n"}}),
      R"(content/1-a/1.1-x.md:4:13: error: the fence and examples/a.cpp differ, first in line 2 [E-example-file]
  4 | ```cpp file=examples/a.cpp
    |             ^~~~~~~~~~~~~~
  note: content/1-a/1.1-x.md:6:1: the lesson has
  6 | }
    | ^
  note: examples/a.cpp:2:1: the file has
  2 | 
    | ^
  cure: the fence is what a reader sees, the file what a learner builds: `mjcourse accept` writes the fence's text into the file
)");
}

TEST(Example, MustHaveAFile) {
  EXPECT_EQ(
      evaluated_mistakes(fence("int main() {}\n")),
      R"(content/1-a/1.1-x.md:4:13: error: cannot read examples/a.cpp: No such file or directory [E-example-file]
  4 | ```cpp file=examples/a.cpp
    |             ^~~~~~~~~~~~~~
  cure: `mjcourse accept` saves the fence's text as examples/a.cpp
)");
}

TEST(Example, MustCompile) {
  EXPECT_EQ(
      example("int main() { return undeclared; }\n").mistakes(),
      R"(content/1-a/1.1-x.md:5:21: error: use of undeclared identifier 'undeclared' [E-example-compile]
  5 | int main() { return undeclared; }
    |                     ^~~~~~~~~~
)");
  EXPECT_EQ(run_mistake("void lost();\nint main() { lost(); }\n"),
            "the program does not link [E-example-compile]\n    undefined reference to `lost()'\n");
}

TEST(Example, MayBeWarnedOf) {
  const EvaluationOf found = example("int main() { int unused; }\n");
  EXPECT_EQ(found.diagnostics().at(0).id, "W-example-compile");
  EXPECT_EQ(found.tally().programs, 1);
}

TEST(Example, MustExitWithZero) {
  EXPECT_EQ(run_mistake("#include <cstdio>\nint main() {\n  for (int i = 1; i < 12; ++i) "
                        "std::fprintf(stderr, \"line %d\\n\", i);\n  return 3;\n}\n"),
            "the program exited with code 3 [E-example-exit]\n"
            "    line 4\n    line 5\n    line 6\n    line 7\n    line 8\n    line 9\n    line 10\n"
            "    line 11\n");
}

TEST(Example, MustNotThrow) {
  EXPECT_EQ(
      run_mistake("#include <stdexcept>\nint main() { throw std::runtime_error(\"lost\"); }\n"),
      "the program threw std::runtime_error: lost [E-example-throws]\n"
      "  cure: catch it, or fix what it complains about\n");
}

TEST(Example, MustNotCrash) {
  EXPECT_EQ(run_mistake("#include <csignal>\nint main() { std::raise(SIGSEGV); }\n"),
            "the program was killed: Segmentation fault [E-example-signal]\n");
}

TEST(Example, MustEnd) {
  EXPECT_EQ(
      run_mistake("int main() {\n  for (volatile int i = 0; i == 0;) {\n  }\n}\n", " timeout=0.5"),
      "the program still ran after 0.5 s, and was stopped [E-example-timeout]\n"
      "  cure: look for a loop without an end; a program that needs longer says "
      "`timeout=SECONDS`\n");
}

TEST(Example, MustNotFlood) {
  EXPECT_EQ(run_mistake("#include <cstdio>\nint main() {\n  for (;;) std::puts(\"flood\");\n}\n"),
            "the program printed more than 1 MiB, and was stopped [E-example-flood]\n"
            "  cure: print what a reader wants to read\n");
}

TEST(Example, MayExitWithAnExpectedCode) {
  const EvaluationOf found = example("int main() { return 3; }\n", " expect=exit:3");
  EXPECT_EQ(found.mistakes(), "");
  EXPECT_EQ(found.tally().programs, 1);
  EXPECT_EQ(run_mistake("int main() {}\n", " expect=exit:3"),
            "the program exited with code 0, and 3 was expected [E-example-exit]\n"
            "  cure: mend the program, or leave `expect` out if 0 is right\n");
}

TEST(Example, GetsItsArguments) {
  EXPECT_EQ(example("#include <cstdio>\nint main(int n, char** all) {\n"
                    "  for (int i = 1; i < n; ++i) std::puts(all[i]);\n}\n",
                    " args=\"a --b=1\"")
                .result<ExampleResult>()
                .output,
            "a\n--b=1\n");
}

TEST(Example, MayBeOptimized) {
  const std::string code =
      "#include <cstdio>\nint main() {\n#ifdef __OPTIMIZE__\n  std::puts(\"fast\");\n#endif\n}\n";
  EXPECT_EQ(example(code, " optimize").result<ExampleResult>().output, "fast\n");
  EXPECT_EQ(example(code).result<ExampleResult>().output, "");
}

TEST(Example, MayBeOneThatDoesNotCompile) {
  const std::string code = "int main() { return undeclared; }\n";
  const EvaluationOf found = example(code, " expect=compile-error");
  EXPECT_EQ(found.mistakes(), "");
  EXPECT_EQ(found.tally().programs, 1);
  EXPECT_EQ(found.result<ExampleResult>().code, code);
  EXPECT_EQ(found.result<ExampleResult>().output,
            "examples/a.cpp:1:21: error: use of undeclared identifier 'undeclared'\n" + code +
                "                    ^\n1 error generated.\n");
  EXPECT_EQ(run_mistake("int main() {}\n", " expect=compile-error"),
            "the program compiles, but the lesson says that it does not [E-example-compiles]\n"
            "  cure: remove `expect=compile-error`, or correct what the lesson says\n");
}

// That is the compiler's word, and not the linker's.
TEST(Example, ThatDoesNotCompileIsNotOneThatDoesNotLink) {
  EXPECT_EQ(run_mistake("void lost();\nint main() { lost(); }\n", " expect=compile-error"),
            "the program does not link [E-example-compile]\n    undefined reference to `lost()'\n");
}

TEST(Unchecked, IsCountedAndNothingElse) {
  const EvaluationOf found("```cpp unchecked\nthis is no program\n```\n");
  EXPECT_EQ(found.mistakes(), "");
  EXPECT_EQ(found.tally().unchecked, 1);
  EXPECT_EQ(found.tally().programs, 0);
}

const std::string kPrints = "#include <cstdio>\nint main() { std::puts(\"a 0.25\\nb\\nc\"); }\n";

TEST(Output, IsWhatTheProgramPrints) {
  const EvaluationOf found = example(kPrints, "", "```text\na 0.26\nb\n[..]\n```\n");
  EXPECT_EQ(found.mistakes(), "");
  EXPECT_EQ(found.result<OutputResult>().lines, 3);
  EXPECT_EQ(found.tally().outputs, 1);
}

TEST(Output, ThatDiffersIsShownLineByLine) {
  const EvaluationOf found = example(kPrints, "", "\nOutput:\n\n```text\na 0.29\nb\n```\n");
  EXPECT_EQ(
      found.mistakes(),
      R"(content/1-a/1.1-x.md:12:1: error: the program prints something else: 1 line of the lesson (-), 2 lines of the program (+) [E-output-differs]
  12 | a 0.29
     | ^~~~~~
    12 - a 0.29
       + a 0.25
           ^~~~
    14 + c
  cure: if the program is right, `mjcourse accept` writes its lines here
)");
  EXPECT_EQ(found.tally().outputs, 0);
  EXPECT_EQ(found.tally().programs, 1);
}

TEST(Output, MayBeTooMuchToLookThrough) {
  const std::string letters(20'000, 'a');
  const EvaluationOf found = example(
      "#include <cstdio>\nint main() { for (int i = 0; i < 60000; ++i) std::putchar('a'); }\n", "",
      "```text\n[..]" + letters + "b\n```\n");
  ASSERT_EQ(found.diagnostics().size(), 1u) << found.mistakes();
  const Diagnostic& gap = found.diagnostics()[0];
  EXPECT_EQ(gap.id, "E-output-gap");
  EXPECT_EQ(gap.place.line, 9);
  EXPECT_EQ(gap.place.column, 1);
  EXPECT_EQ(gap.place.width, 4);
  EXPECT_EQ(gap.message,
            "finding what follows `[..]` would take too long: it may begin at too many "
            "places of a long line");
  EXPECT_EQ(gap.cure,
            "print shorter lines, or state more of them in front of `[..]`, and less after it");
}

TEST(Output, ThatIsEmptyIsNotWhatAProgramPrints) {
  EXPECT_EQ(example(kPrints, "", "```text\n```\n").diagnostics().at(0).message,
            "this output is empty, and the program prints 3 lines (+)");
}

}  // namespace
}  // namespace mjcourse
