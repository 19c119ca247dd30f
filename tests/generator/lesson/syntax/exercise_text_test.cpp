#include "lesson/syntax/exercise_text.h"

#include <gtest/gtest.h>

namespace mjcourse {
namespace {

constexpr const char* kProgram = R"(#include <vector>
// #region helper
int one() { return 1; }
// #endregion
int answer() {
  // #region answer
  return 42;
  // #starter
  // return 0;  // how many?
  //
  //   // #include is no mark here
  // #wrong off-by-one: it is 42
  // return 41;
  // #endregion
}
int main() { return answer(); }
)";

std::optional<ExerciseText> read(const std::string& text, Diagnostics& found) {
  return read_exercise(SourceText("examples/a.cpp", text), "answer", found);
}

ExerciseText good(const std::string& text = kProgram) {
  Diagnostics found;
  auto exercise = read(text, found);
  EXPECT_TRUE(found.empty());
  return exercise.value();
}

TEST(ExerciseText, HasTheSolutionAndWhatMayStandInItsPlace) {
  const ExerciseText exercise = good();
  EXPECT_EQ(exercise.solution(), "  return 42;\n");
  EXPECT_EQ(exercise.starter().code,
            "  return 0;  // how many?\n\n    // #include is no mark here\n");
  ASSERT_EQ(exercise.variants().size(), 2u);
  EXPECT_EQ(exercise.variants()[1].name, "off-by-one");
  EXPECT_EQ(exercise.variants()[1].check, "it is 42");
  EXPECT_EQ(exercise.variants()[1].code, "  return 41;\n");
}

TEST(ExerciseText, GivesAReaderTheProgramWithTheMarksOfItsRegion) {
  EXPECT_EQ(good().program("  return 7;\n"), R"(#include <vector>
int one() { return 1; }
int answer() {
  // #region answer
  return 7;
  // #endregion
}
int main() { return answer(); }
)");
}

TEST(ExerciseText, PutsAVariantWhereItStandsInTheFile) {
  const ExerciseText exercise = good();
  EXPECT_EQ(exercise.in_place(exercise.variants()[1]), R"(#include <vector>
// #region helper
int one() { return 1; }
// #endregion
int answer() {
  // #region answer

  // #starter
  // return 0;  // how many?
  //
  //   // #include is no mark here
  // #wrong off-by-one: it is 42
     return 41;
  // #endregion
}
int main() { return answer(); }
)");
}

TEST(ExerciseText, ShowsTheSolutionAlone) {
  EXPECT_EQ(without_exercise(kProgram), R"(#include <vector>
// #region helper
int one() { return 1; }
// #endregion
int answer() {
  // #region answer
  return 42;
  // #endregion
}
int main() { return answer(); }
)");
  EXPECT_EQ(without_exercise("int main() {}"), "int main() {}");
}

TEST(ExerciseText, TakesTheTextOfARegionOutOfAProgramAndIntoAnother) {
  EXPECT_EQ(code_in_region(good().program("  a;\n\n  b;\n"), "answer"), "  a;\n\n  b;\n");
  EXPECT_EQ(with_code_in_region("f {\n// #region answer\n// #endregion\n}\n", "answer", "a;\nb;\n",
                                "examples/h.cpp"),
            "f {\n// #region answer\n#line 1000000 \"examples/h.cpp\"\na;\nb;\n"
            "#line 3 \"examples/h.cpp\"\n// #endregion\n}\n");
  EXPECT_EQ(with_code_in_region("f {\n// #region answer\n", "answer", "a;\n", "h"), std::nullopt);
}

TEST(ExerciseText, SaysWhatAHandInHasInPlaceOfARegion) {
  const auto says = [](const std::string& program) {
    const auto code = code_in_region(program, "answer");
    return code ? "code: " + *code : code.error();
  };
  const std::string region = "// #region answer\na;\n// #endregion\n";
  EXPECT_EQ(says("// #region other\na;\n// #endregion\n"), "has no region `answer`");
  EXPECT_EQ(says("// #region answer\na;\n"), "has no end of the region `answer`");
  EXPECT_EQ(says("/*\n" + region + "*/\n" + region),
            "has the region `answer` twice, from lines 2 and 6 on: remove one of them");
  EXPECT_EQ(says("// #region answer\n" + region + "// #endregion\n"),
            "has the region `answer` twice, from lines 1 and 2 on: remove one of them");
  for (const char* line : {"//#region answer", "  // # region answer", "#pragma region answer",
                           "// #Region answer", "/* #region answer */", "//  #region answer"}) {
    EXPECT_EQ(says(std::string("int x;\n") + line + "\na;\n// #endregion\n"),
              "has no region `answer`: write line 2 as `// #region answer`");
  }
  for (const char* line : {"//#endregion", "#pragma endregion", "// #endRegion answer"}) {
    EXPECT_EQ(says(std::string("// #region answer\na;\n") + line + "\n}\n"),
              "has no end of the region `answer`: write line 3 as `// #endregion`");
  }
  EXPECT_EQ(says("//#region mine\n" + region + "//#endregion\n"), "code: a;\n");
}

TEST(ExerciseText, SaysWhereAHandInsCodeBegins) {
  Diagnostics none;
  const std::string program =
      "// #region first\n// #endregion\n  // #region answer\n  one();\n  // #starter\n  // two();\n"
      "  // #endregion\n";
  const auto exercise = read_exercise(SourceText("a.cpp", program), "answer", none);
  const std::string whole = exercise->program("three();\n");
  EXPECT_EQ(whole.substr(exercise->code_begin(), 8), "three();");
  EXPECT_EQ(exercise->solution_line(), 4);
  EXPECT_EQ(exercise->code_line(), 2);
  EXPECT_EQ(exercise->numbered_program("three();\n"),
            "  // #region answer\nthree();\n#line 7 \"a.cpp\"\n  // #endregion\n");
  EXPECT_EQ(
      code_in_region("// #region a\nb\n// #region own\nc\n// #endregion\n// #endregion\n", "a"),
      "b\n// #region own\nc\n// #endregion\n");
}

TEST(ExerciseText, StandsCarriageReturns) {
  std::string text = kProgram;
  for (std::size_t at = 0; (at = text.find('\n', at)) != text.npos; at += 2) {
    text.replace(at, 1, "\r\n");
  }
  EXPECT_EQ(good(text).solution(), "  return 42;\n");
  EXPECT_EQ(good(text).starter().code, good().starter().code);
}

// What is wrong is told by tests/courses/exercise; here, that nothing else comes of it.
TEST(ExerciseText, IsNothingWhereItsMarksCannotBeUnderstood) {
  for (const char* region :
       {"", "  // #region answer\n", "  // #region answer\n  a;\n  // #endregion\n",
        "  // #region answer\n  a;\n  // #starter\n  b;\n  // #endregion\n",
        "  // #region answer\n  a;\n  // #starter\n  // b;\n  // #wrong x\n  // #endregion\n",
        "  // #region answer\n  // #starter\n  // b;\n  // #endregion\n"}) {
    Diagnostics found;
    EXPECT_FALSE(read(region, found)) << region;
    EXPECT_EQ(found.size(), 1u) << region;
    EXPECT_EQ(found.front().id, "E-exercise-text");
  }
}

}  // namespace
}  // namespace mjcourse
