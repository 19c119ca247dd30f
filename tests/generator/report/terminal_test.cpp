#include "report/terminal.h"

#include <gtest/gtest.h>

#include <regex>

namespace mjcourse {
namespace {

const std::string kLine = R"(  {"label": "w", "expr": "data.qpso[3]"},)";

Diagnostic misspelt() {
  return {"E-script-name",
          Severity::error,
          {"content/1-a/1.2-b.md", 41, 27, 9, kLine},
          "data.qpso does not exist",
          "",
          {},
          "did you mean `data.qpos`?"};
}

TEST(Terminal, ShowsTheLineTheCaretAndTheCure) {
  EXPECT_EQ(format_for_terminal(misspelt()),
            "content/1-a/1.2-b.md:41:27: error: data.qpso does not exist [E-script-name]\n"
            "  41 |   {\"label\": \"w\", \"expr\": \"data.qpso[3]\"},\n"
            "     |                           ^~~~~~~~~\n"
            "  cure: did you mean `data.qpos`?\n");
}

// A file may be called anything, and the code that fills in a message may forget that.
TEST(Terminal, SaysNothingThatATerminalObeys) {
  const std::string red = "\033[31m";
  const Diagnostic hostile{"E-x",
                           Severity::error,
                           {"a" + red + "\n::b.md", 1, 3, 1, "x" + red + "y"},
                           "m" + red + "\nn",
                           "d" + red + "\ne\tf",
                           {{"k\r", {"n" + red, 0, 0, 1, ""}}},
                           "c" + red};
  EXPECT_EQ(format_for_terminal(hostile),
            "a\\x1b[31m\\n::b.md:1:3: error: m\\x1b[31m\\nn [E-x]\n"
            "  1 | x?[31my\n"
            "    |   ^\n"
            "    d\\x1b[31m\n"
            "    e\tf\n"
            "  note: n\\x1b[31m: k\\r\n"
            "  cure: c\\x1b[31m\n");
}

TEST(Terminal, ColoursWithoutChangingTheText) {
  TerminalStyle style;
  style.colours = true;
  const std::string text = format_for_terminal(misspelt(), style);
  EXPECT_EQ(text,
            "\033[1mcontent/1-a/1.2-b.md:41:27: \033[0m\033[1;31merror: \033[0m"
            "data.qpso does not exist [E-script-name]\n"
            "  41 |   {\"label\": \"w\", \"expr\": \"data.qpso[3]\"},\n"
            "     |                           \033[1;32m^~~~~~~~~\033[0m\n"
            "\033[1m  cure: \033[0mdid you mean `data.qpos`?\n");
}

TEST(Terminal, ShowsDetailNotesAndTheirPlaces) {
  Diagnostic diagnostic = misspelt();
  diagnostic.severity = Severity::warning;
  diagnostic.detail = "first line\n\n  second line\n";
  diagnostic.notes = {{"used here", {"models/zoo.xml", 7, 3, 5, "  <body>"}},
                      {"and nowhere else", {}},
                      {"the whole file", {"models/zoo.xml", 0, 0, 1, ""}}};
  diagnostic.cure = "";
  EXPECT_EQ(format_for_terminal(diagnostic),
            "content/1-a/1.2-b.md:41:27: warning: data.qpso does not exist [E-script-name]\n"
            "  41 |   {\"label\": \"w\", \"expr\": \"data.qpso[3]\"},\n"
            "     |                           ^~~~~~~~~\n"
            "    first line\n"
            "\n"
            "      second line\n"
            "  note: models/zoo.xml:7:3: used here\n"
            "  7 |   <body>\n"
            "    |   ^~~~~\n"
            "  note: and nowhere else\n"
            "  note: models/zoo.xml: the whole file\n");
}

TEST(Terminal, ShowsNoExcerptOfAWholeFile) {
  const Diagnostic diagnostic{
      "E-lesson-name", Severity::error, {"content/a.md", 0, 0, 1, ""}, "no number", "", {}, ""};
  EXPECT_EQ(format_for_terminal(diagnostic), "content/a.md: error: no number [E-lesson-name]\n");
}

// The excerpt of a place, without the message above it.
std::string excerpt(const Place& place, int width = 100) {
  TerminalStyle style;
  style.width = width;
  const std::string text =
      format_for_terminal({"E", Severity::error, place, "m", "", {}, ""}, style);
  return text.substr(text.find('\n') + 1);
}

TEST(Terminal, PutsTheCaretUnderCharactersNotBytes) {
  EXPECT_EQ(excerpt({"a.md", 1, 4, 2, "é→𝄞xy"}),
            "  1 | é→𝄞xy\n"
            "    |    ^~\n");
}

TEST(Terminal, ShowsATabAsOneSpace) {
  EXPECT_EQ(excerpt({"a.md", 1, 3, 1, "\t\tx"}),
            "  1 |   x\n"
            "    |   ^\n");
}

TEST(Terminal, DrawsNothingPastTheLinesEnd) {
  EXPECT_EQ(excerpt({"a.md", 1, 2, 50, "abc"}),
            "  1 | abc\n"
            "    |  ^~\n");
  EXPECT_EQ(excerpt({"a.md", 1, 4, 5, "abc"}),
            "  1 | abc\n"
            "    |    ^\n");
}

TEST(Terminal, CutsALongLineAroundTheCaret) {
  std::string line(200, 'a');
  line.replace(100, 6, "wrong!");
  EXPECT_EQ(excerpt({"a.md", 7, 101, 6, line}, 40),
            "  7 | …aaaaaaaaaaawrong!aaaaaaaaaaaaaaaa…\n"
            "    |             ^~~~~~\n");
}

TEST(Terminal, CutsALongLineOnlyWhereItGoesOn) {
  const std::string line = "first" + std::string(100, '.') + "last";
  EXPECT_EQ(excerpt({"a.md", 7, 1, 5, line}, 30),
            "  7 | first..................…\n"
            "    | ^~~~~\n");
  EXPECT_EQ(excerpt({"a.md", 7, 106, 4, line}, 30),
            "  7 | …...................last\n"
            "    |                     ^~~~\n");
}

TEST(Terminal, CutsBetweenCharacters) {
  std::string line;
  for (int i = 0; i < 60; ++i) line += "é";
  const std::string text = excerpt({"a.md", 7, 30, 1, line}, 30);
  EXPECT_EQ(text,
            "  7 | …ééééééééééééééééééééééé…\n"
            "    |         ^\n");
}

TEST(Terminal, PutsTheCaretUnderWideCharacters) {
  EXPECT_EQ(excerpt({"a.md", 1, 3, 2, "中文字x"}),
            "  1 | 中文字x\n"
            "    |     ^~~\n");
  EXPECT_EQ(excerpt({"a.md", 1, 4, 1, "e\u0301é!"}),  // an accent of its own
            "  1 | e\u0301é!\n"
            "    |   ^\n");
}

TEST(Terminal, CutsWideCharactersToTheWidth) {
  std::string line;
  for (int i = 0; i < 40; ++i) line += "中";
  EXPECT_EQ(excerpt({"a.md", 7, 20, 1, line}, 30),
            "  7 | …中中中中中中中中中中中…\n"
            "    |        ^~\n");
}

// The message of a place in a terminal of `width` columns.
std::string in_terminal(const Diagnostic& diagnostic, int width, bool colours = false) {
  return format_for_terminal(diagnostic, {colours, width, true});
}

TEST(Terminal, WrapsSentencesAtTheTerminalsWidth) {
  Diagnostic diagnostic = misspelt();
  diagnostic.notes = {{"the model that it is asked of is used here for the first time", {}}};
  diagnostic.cure = "did you mean `data.qpos`? `mjcourse explain 1.2:41` says what it depends on";
  EXPECT_EQ(in_terminal(diagnostic, 50),
            "content/1-a/1.2-b.md:41:27: error: data.qpso does\n"
            "    not exist [E-script-name]\n"
            "  41 |   {\"label\": \"w\", \"expr\": \"data.qpso[3]\"},\n"
            "     |                           ^~~~~~~~~\n"
            "  note: the model that it is asked of is used here\n"
            "    for the first time\n"
            "  cure: did you mean `data.qpos`?\n"
            "    `mjcourse explain 1.2:41` says what it depends\n"
            "    on\n");
}

TEST(Terminal, WrapsTheSameWithColours) {
  const std::regex colour("\033\\[[0-9;]*m");
  for (const int width : {40, 50, 80}) {
    EXPECT_EQ(std::regex_replace(in_terminal(misspelt(), width, true), colour, ""),
              in_terminal(misspelt(), width));
  }
}

TEST(Terminal, NeverWrapsWhatIsNotForEyes) {
  Diagnostic diagnostic = misspelt();
  diagnostic.message = std::string(200, 'x') + " y";
  const std::string text = format_for_terminal(diagnostic);
  EXPECT_EQ(text.substr(0, text.find('\n')),
            "content/1-a/1.2-b.md:41:27: error: " + diagnostic.message + " [E-script-name]");
}

TEST(Terminal, TellsWhereMoreIsSaid) {
  Diagnostic other = misspelt();
  other.place = {"a.md", 0, 0, 1, ""};
  other.id = "E-other";
  other.cure = "";
  const std::string both =
      format_for_terminal(misspelt()) + "\na.md: error: data.qpso does not exist [E-other]\n\n";
  EXPECT_EQ(format_for_terminal(Diagnostics{misspelt(), other}, TerminalStyle{}), both);
  EXPECT_EQ(format_for_terminal(Diagnostics{misspelt(), other}, TerminalStyle{false, 80, true}),
            both + "`mjcourse explain E-script-name` tells more of a message\n\n");
  EXPECT_EQ(format_for_terminal(Diagnostics{}, TerminalStyle{false, 80, true}), "");
}

}  // namespace
}  // namespace mjcourse
