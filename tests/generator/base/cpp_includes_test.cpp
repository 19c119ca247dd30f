#include "base/cpp_includes.h"

#include <gtest/gtest.h>

namespace mjcourse {
namespace {

// "<vector> "x.h"" of the includes that are found.
std::string includes_of(const std::string& program) {
  std::string text;
  for (const Include& include : leading_includes(program)) {
    if (!text.empty()) text += ' ';
    text += include.angled ? "<" + include.name + ">" : "\"" + include.name + "\"";
  }
  return text;
}

TEST(LeadingIncludes, AreFoundBehindComments) {
  EXPECT_EQ(
      includes_of("#line 7 \"lesson.md\"\n#pragma once\n// A program.\n/* Of two\n   lines. */\n\n"
                  "#include <cmath>\n  # include \"own.h\"  // ours\n#include <a/b.hpp>\r\n"
                  "int main() {}\n#include <late>\n"),
      "<cmath> \"own.h\" <a/b.hpp>");
  EXPECT_EQ(includes_of("// \"a line\\n\" is printed\n#include <cmath>\n"), "<cmath>");
}

TEST(LeadingIncludes, EndAtWhateverElseIsSaid) {
  for (const char* said :
       {"#define X", "using namespace std;", "#if 1", "#pragma pack(1)", "#include NAME",
        "#include <b> int x;", "#include <b> /* open", "#include <b", "int x;", "// goes on \\",
        "// goes on \\ ", "/* no end", "#inc\\"}) {
    EXPECT_EQ(includes_of("#include <a>\n" + std::string(said) + "\n#include <c>\n"), "<a>")
        << said;
  }
}

TEST(LeadingIncludes, MayBeNone) {
  EXPECT_EQ(includes_of(""), "");
  EXPECT_EQ(includes_of("// only words"), "");
  EXPECT_EQ(includes_of("#"), "");
}

using Names = std::vector<std::string>;

TEST(QuotedIncludes, AreNamedInTheirOrder) {
  EXPECT_EQ(
      quoted_includes("#include <cstdio>\n#include \"b.h\"\n\t# include\t\"sub/a.h\" // why\n"),
      (Names{"b.h", "sub/a.h"}));
}

TEST(QuotedIncludes, AreAlsoThoseThatAConditionLeavesOut) {
  EXPECT_EQ(quoted_includes("#if 0\n#include \"a.h\"\n#endif\n"), Names{"a.h"});
}

TEST(QuotedIncludes, AreNoOtherLines) {
  EXPECT_EQ(quoted_includes("// #include \"a.h\"\nint x; #include \"b.h\"\n#include \"c.h\n"
                            "#include_next \"d.h\"\n#include NAME\n\"e.h\"\n#include \"\"\n"),
            Names());
}

TEST(QuotedIncludes, OfLinesThatEndAsOnWindowsAreTheSame) {
  EXPECT_EQ(quoted_includes("#include \"a.h\"\r\n#include \"b.h\"\r\n"), (Names{"a.h", "b.h"}));
}

TEST(LinkedLibraries, AreMuJoCoAlone) {
  EXPECT_EQ(linked_libraries("#include <mujoco/mujoco.h>\nint main() {}\n"), Names{"mujoco"});
  EXPECT_EQ(linked_libraries("// #include <GL/osmesa.h>\nint main() {}\n"), Names{"mujoco"});
}

TEST(LinkedLibraries, HaveOSMesaForAProgramThatDraws) {
  EXPECT_EQ(linked_libraries("#line 3 \"a.md\"\n#include <cstdio>\n#include <GL/osmesa.h>\n"),
            (Names{"mujoco", "OSMesa"}));
}

}  // namespace
}  // namespace mjcourse
