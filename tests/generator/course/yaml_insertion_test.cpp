#include "course/yaml_insertion.h"

#include <gtest/gtest.h>

namespace mjcourse {
namespace {

const YamlItem kItem{{"folder: x", "title: X"}, "{folder: x, title: X}"};

// With the item as the one at `index` of the list `all`.
std::string with_item(const std::string& text, std::size_t index) {
  return insert_item(text, YAML::Load(text)["all"], index, kItem).value_or("nothing");
}

std::string with_line(const std::string& text, std::size_t index) {
  return append_line(text, YAML::Load(text)["all"][index], "more: 1").value_or("nothing");
}

TEST(YamlInsertion, PutsAnItemBetweenOthers) {
  const std::string text = "all:\n  - folder: a\n    title: A\n  - folder: b\nend: 1\n";
  EXPECT_EQ(with_item(text, 0),
            "all:\n  - folder: x\n    title: X\n  - folder: a\n    title: A\n  - folder: b\n"
            "end: 1\n");
  EXPECT_EQ(with_item(text, 1),
            "all:\n  - folder: a\n    title: A\n  - folder: x\n    title: X\n  - folder: b\n"
            "end: 1\n");
  EXPECT_EQ(with_item(text, 2),
            "all:\n  - folder: a\n    title: A\n  - folder: b\n  - folder: x\n    title: X\n"
            "end: 1\n");
}

TEST(YamlInsertion, LeavesCommentsWhereTheyBelong) {
  EXPECT_EQ(
      with_item("all:\n- folder: a # the first\n  # of a\n  title: A\n# of b\n- folder: b\n", 1),
      "all:\n- folder: a # the first\n  # of a\n  title: A\n- folder: x\n  title: X\n# of b\n"
      "- folder: b\n");
}

TEST(YamlInsertion, KeepsItemsApartThatAre) {
  EXPECT_EQ(with_item("all:\n- folder: a\n\n- folder: b\n", 2),
            "all:\n- folder: a\n\n- folder: b\n\n- folder: x\n  title: X\n");
  EXPECT_EQ(with_item("all:\n- folder: a\n\n- folder: b\n", 0),
            "all:\n- folder: x\n  title: X\n\n- folder: a\n\n- folder: b\n");
}

TEST(YamlInsertion, KeepsHowLinesEndAndThatTheLastDoesNot) {
  EXPECT_EQ(with_item("all:\r\n- folder: a\r\n", 1),
            "all:\r\n- folder: a\r\n- folder: x\r\n  title: X\r\n");
  EXPECT_EQ(with_item("all:\n- folder: a", 1), "all:\n- folder: a\n- folder: x\n  title: X");
}

TEST(YamlInsertion, PutsAnItemIntoBrackets) {
  EXPECT_EQ(with_item("all: []\n", 0), "all: [{folder: x, title: X}]\n");
  EXPECT_EQ(with_item("all: [{folder: a}] # end\n", 1),
            "all: [{folder: a}, {folder: x, title: X}] # end\n");
}

// Between the dash and the item stands another dash, or the end of a line.
TEST(YamlInsertion, LeavesAloneWhatIsLaidOutOtherwise) {
  EXPECT_EQ(with_item("all:\n-\n  folder: a\n", 1), "nothing");
  const std::string nested = "all:\n- - folder: a\n";
  EXPECT_EQ(insert_item(nested, YAML::Load(nested)["all"][0], 1, kItem), std::nullopt);
}

TEST(YamlInsertion, AppendsALineToAnItem) {
  EXPECT_EQ(with_line("all:\n  -  folder: a\n     title: A\n\n  - folder: b\n", 0),
            "all:\n  -  folder: a\n     title: A\n     more: 1\n\n  - folder: b\n");
  EXPECT_EQ(with_line("all:\n- folder: a\n- folder: b", 1),
            "all:\n- folder: a\n- folder: b\n  more: 1");
}

}  // namespace
}  // namespace mjcourse
