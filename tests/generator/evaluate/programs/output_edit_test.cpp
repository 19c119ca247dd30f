#include "evaluate/programs/output_edit.h"

#include <gtest/gtest.h>

#include "evaluate/programs/output_diff.h"
#include "reading_of.h"

namespace mjcourse {
namespace {

constexpr const char* kEditedProgram = "```cpp file=examples/a.cpp\n```\n\n";

std::vector<DiffLine> changes_of(const Output& output, const std::string& printed) {
  Retrials retrials;
  return output_changes(output.text.text, printed, std::nullopt, retrials);
}

// The lesson's body below its program, once what that `printed` is accepted.
std::string accepted(const std::string& body, const std::string& printed) {
  const ReadingOf reading = reading_of(kEditedProgram + body);
  EXPECT_EQ(reading.mistakes(), "");
  const auto& output = reading.only<Output>();
  const Edit edit = output_edit(output, changes_of(output, printed), *reading.lesson);
  EXPECT_EQ(edit.file, kLessonPath);
  EXPECT_EQ(edit.what, "the output of a");
  EXPECT_EQ(edit.before, reading.lesson->source->text());
  std::string text = *edit.before;
  text.replace(edit.span->begin, edit.span->end - edit.span->begin, edit.text);
  const std::string front = std::string("---\ntitle: T\n---\n") + kEditedProgram;
  EXPECT_EQ(text.substr(0, front.size()), front);
  return text.substr(front.size());
}

TEST(OutputEdit, LeavesTheLinesThatAgree) {
  EXPECT_EQ(accepted("```text\nx  0.10\nb\n[..]\n```\n\nText.\n", "x  0.11\nc\nwhatever\n"),
            "```text\nx  0.10\nc\n[..]\n```\n\nText.\n");
}

TEST(OutputEdit, FillsAFenceThatWasLeftEmpty) {
  EXPECT_EQ(accepted("```text\n\n```\n", "a\n\nb\n"), "```text\na\n\nb\n```\n");
}

TEST(OutputEdit, TakesLinesAway) {
  EXPECT_EQ(accepted("```text\na\nb\nc\n```\n", "a\nc\n"), "```text\na\nc\n```\n");
}

TEST(OutputEdit, MakesTheFenceLongerThanWhatLooksLikeItsEnd) {
  EXPECT_EQ(accepted("```text\na\n```\n", "```\n"), "````text\n```\n````\n");
}

TEST(OutputEdit, KeepsTheFilesLineEnds) {
  const ReadingOf reading = reading_of_file(
      "---\r\ntitle: T\r\n---\r\n```cpp file=examples/a.cpp\r\n```\r\n\r\n```text\r\na\r\n```\r\n");
  const auto& output = reading.only<Output>();
  EXPECT_EQ(output_edit(output, changes_of(output, "b\n"), *reading.lesson).text,
            "```text\r\nb\r\n```\r\n");
}

}  // namespace
}  // namespace mjcourse
