#include "evaluate/programs/judge_run.h"

#include <gtest/gtest.h>

namespace mjcourse {
namespace {

const std::string kThrows = "terminate called after throwing an instance of '";

// Of a program that was ended by a signal and had written `err`: the message and what is below it.
std::string killed(const std::string& err) {
  const auto found = judge_run({Outcome::End::killed_by_signal, 6, "", err}, {"program"});
  return found->message + (found->detail.empty() ? "" : "\n" + found->detail);
}

TEST(JudgeRun, NamesAnUncaughtException) {
  EXPECT_EQ(killed("before\n" + kThrows + "int'\nbehind\n"), "the program threw int\nbehind");
  EXPECT_EQ(killed(kThrows + "std::logic_error'\n  what():  one\ntwo\n\nthree\n"),
            "the program threw std::logic_error: one\ntwo\n\nthree");
  EXPECT_EQ(killed(kThrows + "E'\n  what():  \n"), "the program threw E: ");
  EXPECT_EQ(killed(kThrows), "the program was killed: Aborted\n" + kThrows);
}

// What a program writes may be long, no text, or meant for the terminal.
TEST(JudgeRun, BearsWhateverAProgramWrites) {
  EXPECT_EQ(killed("\x1b[2Jred\n\xFF\ttab\n\tplain\n"),
            "the program was killed: Aborted\n\\x1b[2Jred\n\uFFFD\\ttab\n\tplain");
  EXPECT_EQ(killed(kThrows + "X\x1b'\n  what():  a\xC3\n"), "the program threw X\\x1b: a\uFFFD");
  const std::string endless(1 << 20, 'x');
  EXPECT_EQ(killed(kThrows + endless), "the program was killed: Aborted\n" + kThrows + endless);
  EXPECT_EQ(killed(kThrows + "X'\n  what():  " + endless), "the program threw X: " + endless);
}

}  // namespace
}  // namespace mjcourse
