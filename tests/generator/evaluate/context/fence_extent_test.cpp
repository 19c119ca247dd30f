#include "evaluate/context/fence_extent.h"

#include <gtest/gtest.h>

namespace mjcourse {
namespace {

// All of the fence that opens at the first ``` or ~~~ of `text`.
std::string fence_in(const std::string& text) {
  const SourceText lesson("x.md", text);
  const std::size_t begin = std::min(text.find("```"), text.find("~~~"));
  const Span extent = fence_extent(lesson, {begin, text.find('\n', begin)});
  EXPECT_EQ(extent.begin, begin);
  return text.substr(extent.begin, extent.end - extent.begin);
}

TEST(FenceExtent, ReachesToItsClosingLine) {
  EXPECT_EQ(fence_in("a\n```cpp\nint x;\n```\nb\n"), "```cpp\nint x;\n```");
  EXPECT_EQ(fence_in("~~~text\n```\n~~~ \t\nb\n"), "~~~text\n```\n~~~ \t");
}

TEST(FenceExtent, IsClosedByAsManyMarksAsOpenIt) {
  EXPECT_EQ(fence_in("````demo\n```text\nx\n```\n`````\nb\n"), "````demo\n```text\nx\n```\n`````");
  EXPECT_EQ(fence_in("```text\n``` x\n```\n"), "```text\n``` x\n```");
}

TEST(FenceExtent, MayStandInAQuoteOrAList) {
  EXPECT_EQ(fence_in("> ```text\n> x\n> ```\n> b\n"), "```text\n> x\n> ```");
  EXPECT_EQ(fence_in("- ```text\n  x\n  ```\n"), "```text\n  x\n  ```");
}

// What a fence outside of any quote shows of one is text.
TEST(FenceExtent, IsNotClosedInAQuoteThatItShows) {
  EXPECT_EQ(fence_in("```markdown\n> ```\n> x\n> ```\n```\nb\n"),
            "```markdown\n> ```\n> x\n> ```\n```");
  EXPECT_EQ(fence_in("> ```markdown\n> > ```\n> ```\nb\n"), "```markdown\n> > ```\n> ```");
}

TEST(FenceExtent, ReachesToTheEndWhereNothingClosesIt) {
  EXPECT_EQ(fence_in("```text\nx\n``\n"), "```text\nx\n``\n");
}

}  // namespace
}  // namespace mjcourse
