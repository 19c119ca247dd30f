#include "evaluate/programs/region_lines.h"

#include <gtest/gtest.h>

namespace mjcourse {
namespace {

const std::string kLinedProgram =
    "int main() {\n"
    "  // #region a\n"
    "  one();\n"
    "\n"
    "    two();\n"
    "  // #endregion\n"
    "  // #region b\n"
    "  // #region inside\n"
    "  three();\n"
    "  // #endregion\n"
    "  // #endregion\n"
    "  // #region open\n"
    "}\n";

Region region(const std::string& name) {
  return find_region(program_lines(kLinedProgram), name).value();
}

// `program` with the lines of its region `a` made `code`.
std::string replaced(std::string program, const std::string& code) {
  const SourceText file("a.cpp", program);
  const auto found = find_region(program_lines(file.text()), "a");
  const Replacement change = replace_region(file, found.value(), code).value();
  return program.replace(change.span.begin, change.span.end - change.span.begin, change.text);
}

TEST(RegionLines, AreFoundByTheirName) {
  EXPECT_EQ(region_names(program_lines(kLinedProgram)),
            (std::vector<std::string>{"a", "b", "inside", "open"}));
  EXPECT_EQ(joined(region("a").lines), "one();\n\n  two();\n");
  EXPECT_EQ(region("a").indentation, "  ");
  EXPECT_EQ(region("a").lines.front().number, 3);
  EXPECT_FALSE(find_region(program_lines(kLinedProgram), "main"));
}

TEST(RegionLines, KnowWhetherTheyEndAndWhatTheyHold) {
  EXPECT_TRUE(region("b").closed && region("b").holds_marks);
  EXPECT_EQ(joined(region("b").lines), "three();\n");
  EXPECT_TRUE(region("inside").closed && !region("inside").holds_marks);
  EXPECT_FALSE(region("open").closed);
}

TEST(RegionLines, AreReplacedWhereTheyDiffer) {
  const SourceText file("a.cpp", kLinedProgram);
  const auto change = replace_region(file, region("a"), "one();\n\n  2();\n");
  ASSERT_TRUE(change);
  EXPECT_EQ(file.text().substr(change->span.begin, change->span.end - change->span.begin),
            "    two();\n");
  EXPECT_EQ(change->text, "    2();\n");
  EXPECT_FALSE(replace_region(file, region("b"), "3();\n"));
}

TEST(RegionLines, KeepTheFilesIndentationAndLineEnds) {
  const std::string end = "\t// #endregion\n";
  EXPECT_EQ(replaced("\t// #region a\n\tone();\n" + end, "0();\none();\n\n2();\n"),
            "\t// #region a\n\t0();\n\tone();\n\n\t2();\n" + end);
  EXPECT_EQ(replaced("// #region a\r\none();\r\n// #endregion\r\n", "2();\n"),
            "// #region a\r\n2();\r\n// #endregion\r\n");
}

}  // namespace
}  // namespace mjcourse
