#include "evaluate/programs/hand_in_text.h"

#include <gtest/gtest.h>

namespace mjcourse {
namespace {

const char* const kProgram = R"(#include <mjcourse/mjcourse.hpp>
double before(double t) { return t; }
double fallen(double t) {
  // #region answer
  return before(t);
  // #starter
  // return 0;
  // #endregion
}
bool check(double way) { return mjcourse::expect(way > 0, "it falls"); }
int main() {
  check(fallen(1));
}
)";

std::string refusal_of(const std::string& code) {
  Diagnostics diagnostics;
  const auto exercise =
      read_exercise(SourceText("examples/fall.cpp", kProgram), "answer", diagnostics);
  return refusal(code, exercise.value(), "answer");
}

TEST(HandInText, MayDoWhatASolutionDoes) {
  for (const char* code :
       {"  return before(t);", "  const double check = t;\n  return check;",
        "  if (t > 0) {\n    return '{';\n  }\n  return 1'0;  // }", "  return fallen(t / 2);",
        "  using namespace mjcourse;\n  return id_of(nullptr, mjOBJ_BODY, \"}\");"}) {
    EXPECT_EQ(refusal_of(code), "") << code;
  }
}

TEST(HandInText, StaysInItsScope) {
  for (const char* code : {"  return 0; }\ntemplate <class T> void forge(T) {", "  return 0; {",
                           "  return 0; %>\nvoid other() <%"}) {
    EXPECT_EQ(refusal_of(code), "a region closes each brace that it opens, and no other") << code;
  }
}

TEST(HandInText, CallsNothingThatStandsBehindIt) {
  for (const char* code : {"  check(1);\n  return 0;", "  bool check (double);\n  return 0;"}) {
    EXPECT_EQ(refusal_of(code), "what is written calls `check`, which stands behind the region")
        << code;
  }
}

TEST(HandInText, NamesNothingThatReportsChecks) {
  for (const char* word : {"expect", "namespace", "main"}) {
    EXPECT_EQ(refusal_of("  " + std::string(word) + ";"),
              "what is written uses `" + std::string(word) + "`, which no hand-in may");
  }
}

}  // namespace
}  // namespace mjcourse
