#include "report/diff_text.h"

#include <gtest/gtest.h>

#include <sstream>
#include <string>

namespace mjcourse {
namespace {

bool equal(std::string_view a, std::string_view b) {
  return a == b;
}

std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    lines.push_back(text.substr(0, text.find('\n')));
    text.remove_prefix(std::min(text.size(), lines.back().size() + 1));
  }
  return lines;
}

std::string diff(std::string_view before, std::string_view after, const DiffStyle& style = {}) {
  return diff_text(line_diff(lines_of(before), lines_of(after), equal), equal, style);
}

TEST(DiffText, MarksTheWordsThatAreNew) {
  EXPECT_EQ(diff("nq 7 nv 7", "nq 8 nv 66"),
            "1 - nq 7 nv 7\n"
            "  + nq 8 nv 66\n"
            "       ^    ^~\n");
}

TEST(DiffText, MarksTheWordsThatWereMore) {
  EXPECT_EQ(diff("one two three", "one three"),
            "1 - one two three\n"
            "        ^~~\n"
            "  + one three\n");
}

TEST(DiffText, MarksNothingOfLinesThatHaveLittleInCommon) {
  EXPECT_EQ(diff("a b c", "x y c"), "1 - a b c\n  + x y c\n");
}

TEST(DiffText, MarksBehindTabsAndLettersBeyondAscii) {
  EXPECT_EQ(diff("\t\u03b1\u03b2 same 1", "\t\u03b1\u03b2 same 2"),
            "1 - \t\u03b1\u03b2 same 1\n"
            "  + \t\u03b1\u03b2 same 2\n"
            "    \t        ^\n");
}

TEST(DiffText, PutsALineBesideWhatItBecame) {
  EXPECT_EQ(diff("first 1\nsecond 2\n", "new\nfirst 3\nsecond 4\n"),
            "1 + new\n"
            "1 - first 1\n"
            "  + first 3\n"
            "          ^\n"
            "2 - second 2\n"
            "  + second 4\n"
            "           ^\n");
}

TEST(DiffText, NumbersALineThatComesAlone) {
  EXPECT_EQ(diff("a\nc\n", "a\nb\nb2\nc\n"), "2 + b\n  + b2\n");
}

TEST(DiffText, ShowsABlankLineWithoutASpaceBehindItsSign) {
  EXPECT_EQ(diff("a\n\nb\n", "a\nb\n"), "2 -\n");
}

TEST(DiffText, NamesLinesThatMoved) {
  EXPECT_EQ(diff("a\nb\nc\n", "b\nc\na\n"), "1 - a\n4 + a\nline 1 moved below line 3\n");
  EXPECT_EQ(diff("a\nb\nc\n", "c\na\nb\n"), "1 + c\n3 - c\nline 3 moved above line 1\n");
  EXPECT_EQ(diff("a\nb\nx\ny\nz\n", "x\ny\nz\na\nb\n"),
            "1 - a\n2 - b\n6 + a\n  + b\nlines 1-2 moved below line 5\n");
}

TEST(DiffText, FoldsWhatIsLongInTheMiddle) {
  std::string before, after;
  for (int i = 10; i < 20; ++i) after += "line-" + std::to_string(i) + "\n";
  DiffStyle style;
  style.most_rows = 4;
  EXPECT_EQ(diff(before, after, style),
            "1 + line-10\n  + line-11\n  … 6 more lines …\n  + line-18\n  + line-19\n");
}

TEST(DiffText, HasColoursBesideItsSigns) {
  DiffStyle style;
  style.colours = true;
  EXPECT_EQ(diff("a 1", "a 2", style),
            "\033[1;31m1 - a 1\033[0m\n\033[1;32m  + a 2\033[0m\n      ^\n");
}

}  // namespace
}  // namespace mjcourse
