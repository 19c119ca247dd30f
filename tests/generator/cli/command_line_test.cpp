#include "cli/command_line.h"

#include <gtest/gtest.h>

namespace mjcourse {
namespace {

struct Read {
  std::string format, wrong;
  std::filesystem::path out;
  bool strict = false, asks_for_help = false;
  std::vector<std::string> words;
};

Read read_line(const std::vector<std::string>& arguments) {
  Read read;
  CommandLine line("do");
  line.words("[WHAT...]", "what to do", read.words);
  line.flag("--strict", "to the letter", read.strict);
  line.path("--out", kFolder, "where it comes", read.out);
  line.value("--format", {"NAME", "a or b"}, "how", [&](const std::string& value) {
    read.format = value;
    return value == "a" || value == "b";
  });
  try {
    read.asks_for_help = !line.read(arguments);
  } catch (const WrongUsage& wrong) {
    read.wrong = wrong.what();
  }
  return read;
}

std::string wrong_in(const std::vector<std::string>& arguments) {
  return read_line(arguments).wrong;
}

TEST(CommandLine, ReadsOptionsAndWordsInAnyOrder) {
  const Read read = read_line({"x", "--out", "o", "[y, z]", "--format=a", "--strict", "{}"});
  EXPECT_EQ(read.wrong, "");
  EXPECT_EQ(read.out, "o");
  EXPECT_EQ(read.format, "a");
  EXPECT_TRUE(read.strict);
  EXPECT_EQ(read.words, (std::vector<std::string>{"x", "[y, z]", "{}"}));
}

TEST(CommandLine, TakesTheLastOfSeveralValues) {
  EXPECT_EQ(read_line({"--format", "a", "--format", "b"}).format, "b");
  EXPECT_EQ(wrong_in({"--format", "c", "--format", "b"}), "--format takes a or b, not c");
}

TEST(CommandLine, TakesAllBehindTwoDashesForWords) {
  const Read read = read_line({"--strict", "--", "--out", "--", "--help", "-x=y"});
  EXPECT_EQ(read.wrong, "");
  EXPECT_EQ(read.out, "");
  EXPECT_EQ(read.words, (std::vector<std::string>{"--out", "--", "--help", "-x=y"}));
}

TEST(CommandLine, NeedsAValueWhereOneIsMissing) {
  EXPECT_EQ(wrong_in({"--out"}), "--out needs a folder");
  EXPECT_EQ(wrong_in({"--out", "--strict"}), "--out needs a folder");
  EXPECT_EQ(wrong_in({"--out", ""}), "--out needs a folder, not \"\"");
  EXPECT_EQ(wrong_in({"--out=", "--strict"}), "--out needs a folder, not \"\"");
  EXPECT_EQ(read_line({"--out=--strict"}).out, "--strict");
  EXPECT_EQ(read_line({"--out=a=b"}).out, "a=b");
}

TEST(CommandLine, HasAHelpOfAllThatItTakes) {
  EXPECT_TRUE(read_line({"--strict", "--help", "--unknown"}).asks_for_help);
  Read read;
  CommandLine line("do");
  line.words("WHAT", "what to do", read.words);
  line.flag("--strict", "to the letter", read.strict);
  line.path("--a-long-option", kFolder,
            "a sentence that is too long for the rest of the line, so it goes on in the line below",
            read.out);
  EXPECT_EQ(line.form(), "do WHAT");
  EXPECT_EQ(
      line.help("do it"),
      "usage: mjcourse do [OPTIONS] WHAT\n"
      "\n"
      "do it\n"
      "\n"
      "  WHAT           what to do\n"
      "  --strict       to the letter\n"
      "  --a-long-option DIR\n"
      "                 a sentence that is too long for the rest of the line, so it goes on in "
      "the line\n"
      "                 below\n");
}

}  // namespace
}  // namespace mjcourse
