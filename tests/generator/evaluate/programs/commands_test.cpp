#include "evaluate/programs/commands.h"

#include <gtest/gtest.h>

#include "evaluate/evaluation_of.h"

namespace mjcourse {
namespace {

std::string commands(const std::string& lines, const std::string& options = "") {
  return "```sh run" + options + "\n" + lines + "```\n";
}

std::string printed(const std::string& text) {
  return "\n```text\n" + text + "```\n";
}

TEST(Commands, RunOneAfterTheOther) {
  const EvaluationOf found(commands("mkdir build\ncd build\npwd\n") + printed("./build\n"));
  EXPECT_EQ(found.mistakes(), "");
  EXPECT_EQ(found.tally().commands, 1);
  EXPECT_EQ(found.tally().outputs, 1);
  EXPECT_EQ(found.claims()[0].what, "commands: mkdir build");
  EXPECT_EQ(found.claims()[0].how,
            "run by a shell in a folder that has nothing of the course; exit code 0 of each");
  EXPECT_NE(found.claims()[1].how.find("compared with what the commands above it printed"),
            std::string::npos);
}

TEST(Commands, SeeTheFilesThatAreNamedAndNoOthers) {
  const EvaluationOf found(
      commands("find . -type f | sort\ncat docs/a/one\n", " files=\"docs models/ball.xml\"") +
          printed("./docs/a/one\n./docs/two\n./models/ball.xml\nfirst\n"),
      {{"docs/a/one", "first\n"}, {"docs/two", ""}, {"models/other.xml", kBall}});
  EXPECT_EQ(found.mistakes(), "");
}

TEST(Commands, FindThoseThatTheCourseHasNot) {
  EXPECT_EQ(
      evaluated_mistakes(commands("ls\n", " files=\"models/bal.xml\"")),
      R"(content/1-a/1.1-x.md:4:18: error: the course has no `models/bal.xml` [E-commands-file]
  4 | ```sh run files="models/bal.xml"
    |                  ^~~~~~~~~~~~~~
  cure: name a file or a folder as seen from the course's folder
)");
}

TEST(Commands, EndAtTheFirstThatFails) {
  EXPECT_EQ(evaluated_mistakes(commands("echo one\ncat lost\necho two\n")),
            R"(content/1-a/1.1-x.md:4:1: error: the listing exited with code 1 [E-example-exit]
  4 | ```sh run
    | ^~~~~~~~~
    + echo one
    + cat lost
    cat: lost: No such file or directory
)");
}

TEST(Commands, AreStopped) {
  EXPECT_EQ(
      evaluated_mistakes(commands("sleep 60\n", " timeout=0.2")),
      R"(content/1-a/1.1-x.md:4:1: error: the listing still ran after 0.2 s, and was stopped [E-example-timeout]
  4 | ```sh run timeout=0.2
    | ^~~~~~~~~~~~~~~~~~~~~
    + sleep 60
  cure: look for a loop without an end; a listing that needs longer says `timeout=SECONDS`
)");
}

TEST(Commands, LeaveTheCourseAsItIs) {
  const EvaluationOf found(commands("echo more >> notes\n", " files=notes"), {{"notes", "one\n"}});
  EXPECT_EQ(found.mistakes(), "");
  EvaluationOf again(commands("cat notes\n", " files=notes") + printed("one\n"),
                     {{"notes", "one\n"}});
  EXPECT_EQ(again.mistakes(), "");
}

}  // namespace
}  // namespace mjcourse
