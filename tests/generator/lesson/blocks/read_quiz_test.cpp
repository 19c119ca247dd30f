#include "lesson/blocks/read_quiz.h"

#include <gtest/gtest.h>

#include "lesson/quiz_of.h"

namespace mjcourse {
namespace {

TEST(Quiz, NeedsAnIdAndQuestions) {
  EXPECT_EQ(mistakes_in("```quiz\n{\"title\": \"only\"}\n```\n"),
            R"(content/1-a/1.1-x.md:5:1: error: this quiz has no "id" [E-json-missing]
  5 | {"title": "only"}
    | ^
  cure: add "id": …
content/1-a/1.1-x.md:5:1: error: this quiz has no "questions" [E-json-missing]
  5 | {"title": "only"}
    | ^
  cure: add "questions": …
)");
}

TEST(Quiz, HasAnIdOfItsOwn) {
  const std::string quiz = "```quiz\n{\"id\": \"q\", \"questions\": []}\n```\n";
  EXPECT_EQ(mistakes_in(quiz), "");
  EXPECT_EQ(
      mistakes_in(quiz + quiz),
      R"(content/1-a/1.1-x.md:7:1: error: another quiz of this lesson has the id "q" [E-quiz-id]
  7 | ```quiz
    | ^~~~~~~
  cure: give each quiz an id of its own
)");
}

TEST(Quiz, HoldsNoBlocksInItsText) {
  EXPECT_EQ(quiz_mistakes(R"({"kind": "numeric", "answer": 1, "q": "a\n\n```\nb\n```"})"),
            "E-fence-nested <a\\n\\n```\\nb\\n```> Markdown inside JSON cannot hold a code block | "
            "use a code span: `…`\n");
  EXPECT_EQ(quiz_mistakes(R"({"kind": "numeric", "answer": 1, "q": "## a"})"),
            "E-heading-nested <## a> Markdown inside JSON cannot hold a heading | use bold text: "
            "`**…**`\n");
}

TEST(Quiz, LeavesOutAQuestionThatCannotBeAsked) {
  const ReadingOf reading = quiz_of(R"({"kind": "mcq", "q": "?", "options": ["a"], "answer": 0},
    {"kind": "numeric", "q": "What?", "answer": 1})");
  const auto& questions = reading.only<Quiz>().questions;
  ASSERT_EQ(questions.size(), 1u);
  EXPECT_EQ(plain_text(questions[0].text.get()), "What?");
}

}  // namespace
}  // namespace mjcourse
