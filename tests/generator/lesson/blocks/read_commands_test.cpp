#include "lesson/blocks/read_commands.h"

#include <gtest/gtest.h>

#include "reading_of.h"

namespace mjcourse {
namespace {

TEST(ReadCommands, TakesWhatAReaderTypes) {
  const ReadingOf reading = reading_of("```sh run\ncd build\nls\n```\n");
  EXPECT_EQ(reading.mistakes(), "");
  const auto& commands = reading.only<Commands>();
  EXPECT_EQ(commands.code.text, "cd build\nls\n");
  EXPECT_TRUE(commands.files.empty());
  EXPECT_EQ(commands.seconds, 10);
  EXPECT_EQ(reading.place(commands.span), "4:1");
}

TEST(ReadCommands, TakesTheFilesThatTheySee) {
  const ReadingOf reading =
      reading_of("```sh run files=\"examples/a.cpp  models\" timeout=60\nls\n```\n");
  EXPECT_EQ(reading.mistakes(), "");
  const auto& commands = reading.only<Commands>();
  ASSERT_EQ(commands.files.size(), 2);
  EXPECT_EQ(commands.files[0].text, "examples/a.cpp");
  EXPECT_EQ(commands.files[1].text, "models");
  EXPECT_EQ(reading.place(commands.files[1]), "4:34");
  EXPECT_EQ(commands.seconds, 60);
}

TEST(ReadCommands, SeeTheCourseAlone) {
  EXPECT_EQ(
      mistakes_in("```sh run files=\"a/../../b /etc/passwd c\"\nls\n```\n"),
      R"(content/1-a/1.1-x.md:4:18: error: commands see files of the course alone [E-commands-file]
  4 | ```sh run files="a/../../b /etc/passwd c"
    |                  ^~~~~~~~~
  cure: name them as seen from the course's folder: `files="examples/NAME.cpp"`
content/1-a/1.1-x.md:4:28: error: commands see files of the course alone [E-commands-file]
  4 | ```sh run files="a/../../b /etc/passwd c"
    |                            ^~~~~~~~~~~
  cure: name them as seen from the course's folder: `files="examples/NAME.cpp"`
)");
}

TEST(ReadCommands, AreThere) {
  EXPECT_EQ(
      underlined_mistakes(reading_of("```sh run\n\n```\n")),
      "E-commands-empty <```sh run> this fence has no commands | write at least one, as a reader "
      "would type it\n");
}

TEST(ReadCommands, StateWhatTheyPrint) {
  const ReadingOf reading = reading_of("```sh run\nls\n```\n\nOutput:\n\n```text\na\n```\n");
  EXPECT_EQ(reading.mistakes(), "");
  EXPECT_EQ(reading.only<Commands>().outputs.size(), 1);
  EXPECT_FALSE(reading.only<Output>().apart);
}

}  // namespace
}  // namespace mjcourse
