#include "cli/explanation_file.h"

#include <gtest/gtest.h>

namespace mjcourse {
namespace {

Explanation task(int line, const std::string& what, Dependencies now) {
  Explanation explanation;
  explanation.what = what;
  explanation.place = {"content/a.md", line, 1, 1, ""};
  explanation.now = std::move(now);
  return explanation;
}

ExplanationFile file_of(const std::string& compiler, const std::string& model,
                        const std::string& build) {
  ExplanationFile file = explanation_file(
      {task(3, "run one", {{"kind", "program"}, {"compiler", compiler}, {"libraries", build}}),
       task(7, "run two", {{"kind", "program"}, {"compiler", compiler}, {"libraries", build}}),
       task(9, "draw", {{"kind", "figure"}, {"models/ball.xml", model}}),
       task(11, "draw " + model, {{"kind", "figure"}})});
  file.libraries = {{"libc.so.6", "0011223344"}, {"libmujoco.so.2.2.2", build}};
  return file;
}

TEST(ExplanationFile, IsReadAsItWasWritten) {
  const ExplanationFile file = file_of("clang", "a", "b");
  const auto read = read_explanation_file(text_of(file));
  ASSERT_TRUE(read);
  EXPECT_EQ(read->tasks, file.tasks);
  EXPECT_EQ(read->libraries, file.libraries);
  EXPECT_FALSE(explanation_file({}).libraries.empty());
}

TEST(ExplanationFile, NamesTheFirstDifferenceOfEachTaskAndNoneTwice) {
  EXPECT_EQ(differences(file_of("16.0.6", "a", "bbbbbbbbbb"), file_of("16.0.5", "a", "cccccccccc")),
            "compiler: 16.0.6 here, 16.0.5 there\n"
            "  content/a.md:3: run one, and 1 other task\n"
            "2 tasks with the same dependencies\n");
  EXPECT_EQ(differences(file_of("16.0.6", "a", "bbbbbbbbbb"), file_of("16.0.6", "x", "cccccccccc")),
            "libraries: bbbbbbbbbb here, cccccccccc there\n"
            "  content/a.md:3: run one, and 1 other task\n"
            "    libmujoco.so.2.2.2: build bbbbbbbb here, cccccccc there\n"
            "models/ball.xml: a here, x there\n"
            "  content/a.md:9: draw\n"
            "0 tasks with the same dependencies, 1 that the other does not have\n");
}

TEST(ExplanationFile, IsToldWithoutControlCharacters) {
  const ExplanationFile here = explanation_file({task(3, "run\x1b[2J", {{"models/\a", "a\nb"}})});
  const ExplanationFile there = explanation_file({task(3, "run\x1b[2J", {{"models/\a", "c"}})});
  EXPECT_EQ(differences(here, there),
            "models/\\x07: a\\nb here, c there\n"
            "  content/a.md:3: run\\x1b[2J\n"
            "0 tasks with the same dependencies\n");
}

TEST(ExplanationFile, IsNothingElse) {
  for (const std::string none :
       {"", "{}", "[]", "{\"form\": \"mjcourse explain 1\", \"libraries\": 1}"}) {
    EXPECT_EQ(read_explanation_file(none).error(),
              "it is not what `mjcourse explain --json` writes")
        << none;
  }
  EXPECT_EQ(read_explanation_file("{\"form\": \"mjcourse explain 2\"}").error(),
            "another version of mjcourse wrote it");
}

}  // namespace
}  // namespace mjcourse
