#include "lesson/syntax/leading_includes.h"

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

}  // namespace
}  // namespace mjcourse
