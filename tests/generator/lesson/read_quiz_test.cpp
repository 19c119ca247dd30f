#include "lesson/read_quiz.h"

#include <gtest/gtest.h>

#include "reading_of.h"

namespace mjcourse {
namespace {

ReadingOf quiz(const std::string& questions) {
  return reading_of("```quiz\n{\"id\": \"q\", \"questions\": [" + questions + "]}\n```\n");
}

// Each mistake in the questions: id, what it underlines, message.
std::string mistakes(const std::string& questions) {
  std::string text;
  for (const Diagnostic& d : quiz(questions).diagnostics) {
    const auto column = static_cast<std::size_t>(d.place.column - 1);
    text += d.id + " <" + d.place.excerpt.substr(column, static_cast<std::size_t>(d.place.width)) +
            "> " + d.message + (d.cure.empty() ? "" : " | " + d.cure) + "\n";
  }
  return text;
}

TEST(Quiz, ReadsNumbersAndChoices) {
  const ReadingOf reading = quiz(R"(
  {"kind": "numeric", "q": "What is $n_q$?", "answer": 30, "tol": 0.5, "unit": "m",
   "explain": "It is **30**."},
  {"kind": "mcq", "q": "Which?", "options": ["a", "$b$", "c"], "answer": 1})");
  EXPECT_EQ(reading.mistakes(), "");
  const auto& questions = reading.only<Quiz>().questions;
  ASSERT_EQ(questions.size(), 2u);
  EXPECT_EQ(questions[0].answer, 30);
  EXPECT_EQ(questions[0].tolerance, 0.5);
  EXPECT_EQ(questions[0].unit, "m");
  EXPECT_EQ(plain_text(questions[0].explanation.get()), "It is 30.");
  EXPECT_EQ(questions[1].kind, Question::Kind::choice);
  EXPECT_EQ(plain_text(questions[1].options[1].get()), "b");
  EXPECT_EQ(reading.place(questions[1].answer_span), "8:74");
  EXPECT_EQ(reading.all<Math>().size(), 2u);
}

TEST(Quiz, ReadsEveryFormOfProof) {
  const ReadingOf reading = quiz(R"(
  {"kind": "numeric", "q": "?", "answer": 3, "verify": [
    {"joints": {"hinge": 2, "free": 1}, "value": "model.nv"},
    {"model": "zoo", "run": ["a;", "b;"], "seconds": 0.5, "value": "data.time", "equals": 4},
    {"mjcf": ["<mujoco>", "</mujoco>"], "value": "1"}, {"because": "it is a convention"}]},
  {"kind": "mcq", "q": "?", "options": ["a", "b"], "answer": 0, "verify": [
    {"model": "zoo", "options": ["true", "false"]},
    {"model": "zoo", "value": "1", "equals": 1}]})");
  EXPECT_EQ(reading.mistakes(), "");
  const auto& questions = reading.only<Quiz>().questions;
  const auto& proofs = questions[0].proofs;
  ASSERT_EQ(proofs.size(), 4u);
  EXPECT_EQ(proofs[0].joints, (std::map<std::string, int>{{"free", 1}, {"hinge", 2}}));
  EXPECT_EQ(proofs[1].run.text, "a;\nb;");
  EXPECT_EQ(proofs[1].equals, 4);
  EXPECT_EQ(proofs[2].mjcf.text, "<mujoco>\n</mujoco>");
  EXPECT_EQ(proofs[3].because.text, "it is a convention");
  EXPECT_EQ(questions[1].proofs[0].options[1].text, "false");
}

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

TEST(Question, IsOfAKindThatThereIs) {
  EXPECT_EQ(mistakes(R"({"kind": "numerc"})"),
            "E-quiz-form <numerc> there is no question of kind \"numerc\" | did you mean "
            "`numeric`?\n");
  EXPECT_EQ(mistakes("{}"), "E-json-missing <{> this question has no \"kind\" | add \"kind\": …\n");
  for (const std::string kind : {"multi", "order"}) {
    EXPECT_EQ(mistakes("{\"kind\": \"" + kind + "\"}"),
              "E-not-yet <" + kind + "> a question of kind \"" + kind +
                  "\" belongs to the lesson language, but this version of mjcourse cannot do it "
                  "yet\n");
  }
}

TEST(Question, AsksAndAnswers) {
  EXPECT_EQ(mistakes(R"({"kind": "numeric"})"),
            "E-json-missing <{> this question has no \"q\" | add \"q\": …\n"
            "E-json-missing <{> this question has no \"answer\" | add \"answer\": …\n");
  EXPECT_EQ(mistakes(R"({"kind": "numeric", "q": "?", "answer": "5", "tolerance": 1})"),
            "E-json-kind <\"5\"> \"answer\" is a string; expected a number\n"
            "E-json-key <tolerance> a question has no key \"tolerance\" | known: kind, q, explain, "
            "answer, tol, unit, verify\n");
  EXPECT_EQ(mistakes(R"({"kind": "mcq", "q": "?", "answer": 0})"),
            "E-json-missing <{> this question has no \"options\" | add \"options\": …\n");
}

TEST(Question, HasAnAnswerAmongItsOptions) {
  for (const std::string answer : {"2", "-1", "0.5"}) {
    EXPECT_EQ(
        mistakes(R"({"kind": "mcq", "q": "?", "options": ["a", "b"], "answer": )" + answer + "}"),
        "E-quiz-form <" + answer +
            "> \"answer\" is the index of the right option, counted from 0\n");
  }
  EXPECT_EQ(mistakes(R"({"kind": "mcq", "q": "?", "options": ["a", 5], "answer": 0})"),
            "E-json-kind <5> \"options\" is a number; expected a string\n");
}

// The mistakes of a numeric question with the proof `proof`.
std::string proof_mistakes(const std::string& proof) {
  return mistakes(R"({"kind": "numeric", "q": "?", "answer": 5, "verify": [)" + proof + "]}");
}

TEST(Proof, BuildsOneThing) {
  const std::string form =
      "E-proof-form <{> a proof needs exactly one of \"joints\", \"model\", \"mjcf\" and "
      "\"because\"\n";
  EXPECT_EQ(proof_mistakes(R"({"value": "1"})"), form);
  EXPECT_EQ(proof_mistakes(R"({"model": "a", "joints": {}, "value": "1"})"), form);
  EXPECT_EQ(proof_mistakes(R"({"model": "a", "mjcf": "<mujoco/>", "value": "1"})"), form);
  EXPECT_EQ(proof_mistakes(R"({"because": ""})"), form);
  EXPECT_EQ(proof_mistakes("3"), "E-json-kind <3> \"proof\" is a number; expected an object\n");
}

TEST(Proof, FindsAValue) {
  const std::string form =
      "E-proof-form <{> a proof needs a \"value\", or \"options\" with one "
      "expression for each option\n";
  EXPECT_EQ(proof_mistakes(R"({"model": "a"})"), form);
  EXPECT_EQ(proof_mistakes(R"({"model": "a", "value": "1", "options": ["1"]})"), form);
  EXPECT_EQ(proof_mistakes(R"({"model": "a", "value": "1", "equls": 3})"),
            "E-json-key <equls> a proof has no key \"equls\" | did you mean `equals`?\n");
}

TEST(Proof, CountsJoints) {
  EXPECT_EQ(proof_mistakes(R"({"joints": {"hinge": -1}, "value": "1"})"),
            "E-json-range <-1> \"hinge\" counts joints: a whole number from 0 to 1000\n");
  EXPECT_EQ(proof_mistakes(R"({"joints": {"slide": 1.5, "hing": 3}, "value": "1"})"),
            "E-json-range <1.5> \"slide\" counts joints: a whole number from 0 to 1000\n"
            "E-json-key <hing> a set of joints has no key \"hing\" | did you mean `hinge`?\n");
}

TEST(Proof, OfAChoiceHasAnExpressionForEachOption) {
  const std::string choice =
      R"({"kind": "mcq", "q": "?", "options": ["a", "b"], "answer": 0, "verify": [)";
  EXPECT_EQ(mistakes(choice + R"({"model": "a", "options": ["1"]}]})"),
            "E-proof-form <{> the proof has 1 expressions for 2 options | write one expression for "
            "each option, in their order\n");
  EXPECT_EQ(mistakes(choice + R"({"model": "a", "value": "1"}]})"),
            "E-proof-form <{> a choice is proved by \"options\", one expression each; a \"value\" "
            "needs \"equals\"\n");
  EXPECT_EQ(proof_mistakes(R"({"model": "a", "options": ["1", "2"]})"),
            "E-proof-form <{> the proof has 2 expressions for 0 options | write one expression for "
            "each option, in their order\n");
}

TEST(Proof, IsLeftOutWhenItDoesNotSayWhatToDo) {
  const ReadingOf reading = quiz(R"({"kind": "numeric", "q": "?", "answer": 5, "verify": [{},
      {"because": "so"}]})");
  EXPECT_EQ(reading.only<Quiz>().questions[0].proofs.size(), 1u);
}

TEST(Quiz, SaysWhatThisVersionCannotDoYet) {
  const std::string later =
      " belongs to the lesson language, but this version of mjcourse cannot "
      "do it yet | leave it out for now\n";
  EXPECT_EQ(mistakes(R"({"kind": "numeric", "q": "?", "answer": 5, "hint": "h"})"),
            "E-not-yet <hint> \"hint\"" + later);
  EXPECT_EQ(proof_mistakes(R"({"example": "x", "because": "y"})"),
            "E-not-yet <example> \"example\"" + later);
}

TEST(Quiz, HoldsNoBlocksInItsText) {
  EXPECT_EQ(mistakes(R"({"kind": "numeric", "answer": 1, "q": "a\n\n```\nb\n```"})"),
            "E-fence-nested <a\\n\\n```\\nb\\n```> Markdown inside JSON cannot hold a code block | "
            "use a code span: `…`\n");
  EXPECT_EQ(mistakes(R"({"kind": "numeric", "answer": 1, "q": "## a"})"),
            "E-heading-nested <## a> Markdown inside JSON cannot hold a heading | use bold text: "
            "`**…**`\n");
}

}  // namespace
}  // namespace mjcourse
