#include "lesson/syntax/table_row.h"

#include <gtest/gtest.h>

namespace mjcourse {
namespace {

std::vector<std::string> cells(const std::string& row) {
  std::vector<std::string> found;
  for (const RowCell& cell : cells_of_row(row)) {
    found.push_back(row.substr(cell.begin, cell.end - cell.begin));
  }
  return found;
}

using Cells = std::vector<std::string>;

TEST(TableRow, EndsACellAtEachBar) {
  EXPECT_EQ(cells("| a | b |"), (Cells{" a ", " b "}));
  EXPECT_EQ(cells("a|b"), (Cells{"a", "b"}));
  EXPECT_EQ(cells("| a | |"), (Cells{" a ", " "}));
  EXPECT_EQ(cells(R"(| a\|b | c\\|d |  )"), (Cells{R"( a\|b )", R"( c\\|d )"}));
  EXPECT_EQ(cells("|"), Cells{});
  EXPECT_EQ(cells(""), Cells{});
}

// What is cut, and at which byte.
std::string cut(const std::string& row) {
  const auto bar = cutting_bar(row);
  return bar ? std::string(bar->within) + " " + std::to_string(bar->at) : "";
}

TEST(TableRow, KnowsABarThatCuts) {
  EXPECT_EQ(cut("| $|x|$ | 1 |"), "a formula 3");
  EXPECT_EQ(cut("| 1 | `p|q` |"), "code 8");
  EXPECT_EQ(cut("| ``a`|b`` |"), "code 6");
  EXPECT_EQ(cut("| $$a|b$$ |"), "a formula 5");
}

TEST(TableRow, CutsNoMoneyAndNoVariables) {
  for (const char* row :
       {"| $5 | $6 |", "|$5|$6|", "|$HOME|$PATH|", "| 5$ | 6$ |", R"(| $\|x\|$ | `a\|b` |)",
        "| ` | b |", "| \\$a | b$ |", "|$x$|$y$|", "|`x`|`y`|"}) {
    EXPECT_EQ(cut(row), "") << row;
  }
}

}  // namespace
}  // namespace mjcourse
