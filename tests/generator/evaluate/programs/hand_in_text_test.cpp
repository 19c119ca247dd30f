#include "evaluate/programs/hand_in_text.h"

#include <gtest/gtest.h>

namespace mjcourse {
namespace {

const char* const kProgram = R"(#include <mjcourse/mjcourse.hpp>
double fallen(double t) {
  // #region answer
  return t;
  // #starter
  // #pragma unroll
  // return __builtin_sqrt(t);
  // #endregion
}
int main() { mjcourse::expect(fallen(1) > 0, "it falls"); }
)";

// Why it is refused, and what of it.
std::string refusal_of(const std::string& code, const std::string& program = kProgram) {
  const Toolchain toolchain = Toolchain::find().value();
  Diagnostics none;
  const auto exercise = read_exercise(SourceText("examples/fall.cpp", program), "answer", none);
  const auto rules = hand_in_rules(exercise.value(), toolchain);
  const auto faults = hand_in_faults({code + "\n"}, rules.value().rules, toolchain);
  const auto& fault = faults.value().front();
  if (!fault) return "";
  return fault->why + ": " +
         (code + "\n").substr(fault->span.begin, fault->span.end - fault->span.begin);
}

TEST(HandInText, MayDoWhatAnyCodeDoes) {
  for (const char* code :
       {"return t;", "const double check = t;\nreturn check;", "return record * signal;",
        "if (t > 0) {\n  return '{';\n}\nreturn 1'0;  // }", "return fallen(t / 2);  // expect(",
        "using namespace mjcourse;\nreturn id_of(nullptr, mjOBJ_BODY, \"}\");",
        "const char* text = R\"(\nexpect(\n)\"; /* \\\n asm */", "[[maybe_unused]] int \u00e4 = 1;",
        "#pragma  unroll // as the starter has it\nreturn __builtin_sqrt(t);", "",
        "const char* message = \"exit \\\\ main\";"}) {
    EXPECT_EQ(refusal_of(code), "") << code;
  }
}

TEST(HandInText, StaysInItsScope) {
  const std::string why = "a region closes each bracket that it opens, and no other: ";
  EXPECT_EQ(refusal_of("return 0; }\ntemplate <class T> void forge(T) {"), why + "}");
  EXPECT_EQ(refusal_of("return 0; {"), why + "{");
  EXPECT_EQ(refusal_of("return 0; %>\nvoid other() <%"), why + "%>");
  EXPECT_EQ(refusal_of("int a = 1'0; } int b = 2'0; {"), why + "}");
  EXPECT_EQ(refusal_of("\u00e41'0; } '1"), "");  // as clang reads it, one quote
  EXPECT_EQ(refusal_of("f("), why + "(");
}

TEST(HandInText, HasTheDirectivesOfItsAuthorAlone) {
  const std::string why = "a region has no other preprocessor directives than its solution: ";
  EXPECT_EQ(refusal_of("#define double int"), why + "#define double int");
}

TEST(HandInText, IsWhatItSeems) {
  EXPECT_EQ(refusal_of("// a\rexpect(true, \"\");"),
            "a carriage return stands alone, which ends a line for some: \r");
  EXPECT_EQ(refusal_of("ex\\\npect(true, \"\");"),
            "a line ends with a backslash, so the next one belongs to it: \\");
  EXPECT_EQ(refusal_of("// a \\  \nb"),
            "a line ends with a backslash, so the next one belongs to it: \\");
  EXPECT_EQ(refusal_of("u8\\\nR\"x(\n)x\";"), "");
  const std::string why = "C++ has no such character here, ";
  EXPECT_EQ(refusal_of("return t; @x"), why + "U+0040: @");
  EXPECT_EQ(refusal_of("return t; `x"), why + "U+0060: `");
  EXPECT_EQ(refusal_of("return t; \\x"), why + "U+005C: \\");
  EXPECT_EQ(refusal_of("return\u00a0t;"), why + "U+00A0: \u00a0");
  EXPECT_EQ(refusal_of("\\u0061sm(\"\");"), why + "U+005C: \\");
  EXPECT_EQ(refusal_of("int $a;"), why + "U+0024: $");
  EXPECT_EQ(refusal_of("const char* s = \"open;"),
            "a quote or a comment is opened and not closed: \"");
  EXPECT_EQ(refusal_of("return t; /* open"), "a quote or a comment is opened and not closed: /");
  EXPECT_EQ(refusal_of("return t;\f"), "a region has no control characters: \f");
  EXPECT_EQ(refusal_of(std::string("return t;\0", 10)),
            std::string("a region has no control characters: \0", 37));
}

TEST(HandInText, NamesNothingThatEndsOrReplacesTheChecks) {
  const auto refused = [](const std::string& word) {
    return "a hand-in may not use `" + word + "`: " + word;
  };
  for (const std::string word : {"expect", "namespace", "main", "asm", "__asm__", "_Pragma",
                                 "__builtin_LINE", "MJCOURSE_JUDGE", "extern"}) {
    EXPECT_EQ(refusal_of(word + " x;"), refused(word));
  }
  EXPECT_EQ(refusal_of("[[gnu::constructor]] void f();"), refused("gnu"));
  EXPECT_EQ(refusal_of("[[using clang: annotate]] int f();"), refused("clang"));
  EXPECT_EQ(refusal_of("void operator delete(void*);"),
            "a hand-in may not use `operator delete`: operator");
  EXPECT_EQ(refusal_of("namespace mjcourse { int x; }"), refused("namespace"));
  EXPECT_EQ(refusal_of("namespace m = mjcourse;"), "");
  EXPECT_EQ(refusal_of("namespace { int x; }"), "");
  EXPECT_EQ(refusal_of("return x ? gnu : clang;"), "");
}

TEST(HandInText, BecomesNoneOfTheseByAMacro) {
  const Toolchain toolchain = Toolchain::find().value();
  Diagnostics none;
  const auto exercise = read_exercise(SourceText("examples/fall.cpp", kProgram), "answer", none);
  HandInRules rules = hand_in_rules(exercise.value(), toolchain).value().rules;
  const auto why = [&](const std::string& text) {
    const auto fault = rules.expanded_fault(text, raw_tokens({text}, toolchain).value().front());
    return fault ? fault->why + ": " +
                       text.substr(fault->span.begin, fault->span.end - fault->span.begin)
                 : "";
  };
  const auto refused = [](const std::string& word) {
    return "a hand-in may not use `" + word + "`, which a macro makes here: " + word;
  };
  EXPECT_EQ(why("# 7 \"a.cpp\"\n asm(\"nop\");\n"), refused("asm"));
  EXPECT_EQ(why("__attribute__((used)) int x;\n"), refused("__attribute__"));
  EXPECT_EQ(why("[[gnu::constructor]] void f();\n"), refused("gnu"));
  const std::string pragma = "#pragma redefine_extname snprintf mine";
  EXPECT_EQ(why("int x;\n" + pragma + "\n# 8 \"a.cpp\" 2\nint y;\n"),
            "a macro makes the directive `# pragma redefine_extname snprintf mine`, and a region "
            "has none: " +
                pragma);
  EXPECT_EQ(why("return __builtin_nanf(\"\") + __builtin_sqrt(t) + (x == __null);\n"), "");
  const std::string solution = "__attribute__((always_inline)) int x;\n#pragma pack(1)\n";
  EXPECT_NE(why(solution), "");
  rules.allow_expanded(solution, raw_tokens({solution}, toolchain).value().front());
  EXPECT_EQ(why(solution), "");
}

}  // namespace
}  // namespace mjcourse
