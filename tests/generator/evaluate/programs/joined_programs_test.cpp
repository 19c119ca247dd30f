#include "evaluate/programs/joined_programs.h"

#include <gtest/gtest.h>

namespace mjcourse {
namespace {

std::string version(const std::string& answer, const std::string& main = "int main() {") {
  return "// A program.\n#include <cstdio>\n\nint answer() { return " + answer + "; }\n\n" + main +
         "\n  std::printf(\"%d\", answer());\n}\n";
}

TEST(JoinedPrograms, AreOneProgramThatChoosesByItsFirstArgument) {
  EXPECT_EQ(joined_programs({{version("1")}, {version("2", "int main(int, char**) {")}},
                            "examples/a.cpp"),
            R"(// A program.
#include <cstdio>
#ifdef __clang__
#pragma clang diagnostic ignored "-Weverything"
#endif
namespace version_0 {
#line 3 "examples/a.cpp"

int answer() { return 1; }

int main_of_version() {
  std::printf("%d", answer());
return 0; }
}
namespace version_1 {
#line 3 "examples/a.cpp"

int answer() { return 2; }

int main_of_version(int, char**) {
  std::printf("%d", answer());
return 0; }
}
#line 1 "joined.cpp"
inline int call(int (*version)(), int, char**) { return version(); }
inline int call(int (*version)(int, char**), int count, char** words) {
  return version(count, words);
}
int main(int count, char** words) {
  const int index = words[1][0] - 'a';
  words[1] = words[0];
  if (index == 0) return (call(version_0::main_of_version, count - 1, words + 1));
  if (index == 1) return (call(version_1::main_of_version, count - 1, words + 1));
  return 1;
}
)");
  EXPECT_EQ(joined_arguments(1, {"-n", "3"}), (std::vector<std::string>{"b", "-n", "3"}));
}

TEST(JoinedPrograms, AreInTheGlobalNamespaceWhereThereIsOneAlone) {
  const std::string names = "namespace version_0 {}\nusing namespace version_0;\n";
  EXPECT_NE(joined_programs({{version("1")}}, "a")->find(names), std::string::npos);
  EXPECT_EQ(joined_programs({{version("1")}, {version("2")}}, "a")->find(names), std::string::npos);
}

TEST(JoinedPrograms, StayApartWhereTheCompilerIsToldMore) {
  const std::string plain = version("1");
  EXPECT_FALSE(joined_programs({{plain}, {"#include <vector>\n" + plain}}, "a"))
      << "other includes";
  EXPECT_FALSE(joined_programs({{version("1;\n#define x 1\n")}}, "a"));
  EXPECT_TRUE(joined_programs({{version("1;\n#line 7 \"b.cpp\"\n")}}, "a"));
  EXPECT_FALSE(joined_programs({{version("1", "int main() { return 0; }")}}, "a"));
  EXPECT_FALSE(joined_programs({{version("1", "auto main() -> int {")}}, "a"))
      << "no main() is seen";
  EXPECT_FALSE(joined_programs({{version("1") + version("2")}}, "a")) << "there are two";
  const std::string inside = version("1", "int main() {\n  // #region answer\n  // #endregion");
  EXPECT_FALSE(joined_programs({{inside}}, "a")) << "a line } may be its reader's";
}

TEST(JoinedPrograms, HaveTheLinesOfAStrangerAsTheyAre) {
  const std::string lines =
      "#line 1 \"m\"\nconst char* s = R\"(\n#hash\nint main(\n}\n)\";\n#line 2 \"m\"\n";
  const std::string program = version("1; }\n" + lines + "int other() { return 2");
  EXPECT_FALSE(joined_programs({{program}}, "a"));
  const auto joined = joined_programs({{program, "", "m"}}, "a");
  ASSERT_TRUE(joined);
  EXPECT_NE(joined->find(lines), joined->npos) << *joined;
  EXPECT_NE(joined->find("int main_of_version() {\n"), joined->npos) << *joined;
}

}  // namespace
}  // namespace mjcourse
