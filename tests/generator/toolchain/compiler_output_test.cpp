#include "toolchain/compiler_output.h"

#include <gtest/gtest.h>

namespace mjcourse {
namespace {

using Names = std::vector<std::string>;

TEST(CompilerOutput, NamesTheFilesThatWereRead) {
  EXPECT_EQ(parse_dependencies("/w/a: /w/a.cpp /usr/lib/../include/b.h \\\n  /c/with\\ blank.h \\\n"
                               "  /c/$$1.h /c/\\#2.h /c/d:.h rel.h\n",
                               "/w"),
            (Names{"/c/#2.h", "/c/$1.h", "/c/d:.h", "/c/with blank.h", "/usr/include/b.h"}));
  EXPECT_EQ(parse_dependencies("", "/w"), Names{});
  EXPECT_EQ(parse_dependencies("/w/a: /w/a.cpp\n", "/w"), Names{});
}

TEST(CompilerOutput, NamesAFileOnce) {
  EXPECT_EQ(parse_dependencies("a: /b/../c.h /c.h\n", "/w"), Names{"/c.h"});
}

TEST(CompilerOutput, HasMessagesWithTheirPlaces) {
  const auto messages = parse_messages(
      "In file included from a.cpp:1:\n/x/b.h:3:7: warning: odd [-Wodd]\na.cpp:12:1: fatal error: "
      "no: such\nclang: error: linker command failed\n");
  ASSERT_EQ(messages.size(), 2U);
  EXPECT_EQ(messages[0].file, "/x/b.h");
  EXPECT_EQ(messages[0].text, "odd [-Wodd]");
  EXPECT_EQ(messages[1].line, 12);
  EXPECT_EQ(messages[1].severity, "fatal error");
  EXPECT_EQ(messages[1].text, "no: such");
}

// What a program has its compiler say with `#line` and `#error`.
TEST(CompilerOutput, IsPassedOverWhereNoPlaceHasSuchNumbers) {
  EXPECT_TRUE(parse_messages("//a:99999999999999999999:1: error: x\n").empty());
  EXPECT_TRUE(parse_messages("a.cpp:1:99999999999: error: x\n").empty());
  const auto messages = parse_messages("a:9:b.cpp:3:4: error: " + std::string(100'000, 'x') +
                                       "\na\xff.cpp:5:6: note: \xfe\n");
  ASSERT_EQ(messages.size(), 2u);
  EXPECT_EQ(messages[0].file, "a:9:b.cpp");
  EXPECT_EQ(messages[0].line, 3);
  EXPECT_EQ(messages[0].text.size(), 100'000u);
  EXPECT_EQ(messages[1].file, "a\xff.cpp");
}

}  // namespace
}  // namespace mjcourse
