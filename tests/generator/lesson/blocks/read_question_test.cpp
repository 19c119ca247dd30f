#include "lesson/blocks/read_question.h"

#include <gtest/gtest.h>

#include "lesson/quiz_of.h"

namespace mjcourse {
namespace {

// What stands in front of the JSON that a test is about.
const std::string kNumeric = R"({"kind": "numeric", "q": "?", )";
const std::string kMcq = R"({"kind": "mcq", "q": "?", )";
const std::string kMulti = R"({"kind": "multi", "q": "?", )";
const std::string kOrder = R"({"kind": "order", "q": "?", )";

TEST(Question, ReadsANumber) {
  const ReadingOf reading = quiz_of(R"(
  {"kind": "numeric", "q": "What is $n_q$?", "answer": 30, "tol": 0.5, "unit": "m",
   "hint": "Count `them`.", "explain": "It is **30**."})");
  EXPECT_EQ(reading.mistakes(), "");
  const Question& question = reading.only<Quiz>().questions.at(0);
  EXPECT_EQ(question.answer, 30);
  EXPECT_EQ(question.tolerance.around(question.answer), 0.5);
  EXPECT_EQ(question.unit, "m");
  EXPECT_EQ(plain_text(question.hint.get()), "Count them.");
  EXPECT_EQ(plain_text(question.explanation.get()), "It is 30.");
  EXPECT_EQ(reading.all<Math>().size(), 1u);
}

TEST(Question, ReadsAChoice) {
  const ReadingOf reading = quiz_of(R"(
  {"kind": "mcq", "q": "Which?", "answer": 1,
   "options": ["a", {"text": "$b$", "feedback": "Yes, $b$."}, {"text": "c"}]})");
  EXPECT_EQ(reading.mistakes(), "");
  const Question& question = reading.only<Quiz>().questions.at(0);
  EXPECT_EQ(question.kind, Question::Kind::mcq);
  EXPECT_EQ(question.right, std::vector<std::size_t>{1});
  EXPECT_EQ(plain_text(question.options[1].text.get()), "b");
  EXPECT_EQ(plain_text(question.options[1].feedback.get()), "Yes, b.");
  EXPECT_EQ(question.options[0].feedback, nullptr);
  EXPECT_EQ(question.options[2].feedback, nullptr);
  EXPECT_EQ(reading.place(question.answer_span), "6:44");
  EXPECT_EQ(reading.all<Math>().size(), 2u);
}

TEST(Question, ReadsAChoiceOfSeveral) {
  const ReadingOf reading = quiz_of(kMulti + R"("options": ["a", "b", "c"], "answer": [2, 0]})");
  EXPECT_EQ(reading.mistakes(), "");
  const Question& question = reading.only<Quiz>().questions.at(0);
  EXPECT_EQ(question.kind, Question::Kind::multi);
  EXPECT_EQ(question.right, (std::vector<std::size_t>{0, 2}));
}

TEST(Question, ReadsAnOrder) {
  const ReadingOf reading = quiz_of(kOrder + R"("items": ["`one`", "two", "three"]})");
  EXPECT_EQ(reading.mistakes(), "");
  const Question& question = reading.only<Quiz>().questions.at(0);
  EXPECT_EQ(question.kind, Question::Kind::order);
  ASSERT_EQ(question.options.size(), 3u);
  EXPECT_EQ(plain_text(question.options[0].text.get()), "one");
  EXPECT_EQ(reading.place(question.options[1].span), "5:74");
}

TEST(Question, IsOfAKindThatThereIs) {
  EXPECT_EQ(quiz_mistakes(R"({"kind": "numerc"})"),
            "E-quiz-form <numerc> there is no question of kind \"numerc\" | did you mean "
            "`numeric`?\n");
  EXPECT_EQ(quiz_mistakes(R"({"kind": "essay"})"),
            "E-quiz-form <essay> there is no question of kind \"essay\" | known: numeric, mcq, "
            "multi, order\n");
  EXPECT_EQ(quiz_mistakes("{}"),
            "E-json-missing <{> this question has no \"kind\" | add \"kind\": …\n");
}

TEST(Question, AsksAndAnswers) {
  EXPECT_EQ(quiz_mistakes(R"({"kind": "numeric"})"),
            "E-json-missing <{> this question has no \"q\" | add \"q\": …\n"
            "E-json-missing <{> this question has no \"answer\" | add \"answer\": …\n");
  EXPECT_EQ(quiz_mistakes(kNumeric + R"("answer": "5", "tolerance": 1})"),
            "E-json-kind <\"5\"> \"answer\" is a string; expected a number\n"
            "E-json-key <tolerance> a question has no key \"tolerance\" | known: kind, q, hint, "
            "explain, tol, unit, answer, verify\n");
  EXPECT_EQ(quiz_mistakes(kMcq + R"("answer": 0})"),
            "E-json-missing <{> this question has no \"options\" | add \"options\": …\n");
  EXPECT_EQ(quiz_mistakes(kMulti + R"("options": ["a", "b"]})"),
            "E-json-missing <{> this question has no \"answer\" | add \"answer\": …\n");
  EXPECT_EQ(quiz_mistakes(kOrder + "\"item\": []}"),
            "E-json-missing <{> this question has no \"items\" | add \"items\": …\n"
            "E-json-key <item> a question has no key \"item\" | did you mean `items`?\n");
}

TEST(Question, HasKeysOfItsKindOnly) {
  EXPECT_EQ(quiz_mistakes(kMcq + R"("options": ["a", "b"], "answer": 0, "tol": 1})"),
            "E-json-key <tol> a question has no key \"tol\" | known: kind, q, hint, explain, "
            "options, answer, verify\n");
  EXPECT_EQ(quiz_mistakes(kOrder + R"("items": ["a", "b"], "answer": [0, 1]})"),
            "E-quiz-form <[0, 1]> an order has no \"answer\": its \"items\" stand in the right "
            "order | leave \"answer\" out\n");
  EXPECT_EQ(quiz_mistakes(kNumeric + R"("answer": 1, "hints": "h"})"),
            "E-json-key <hints> a question has no key \"hints\" | did you mean `hint`?\n");
}

TEST(Choice, HasAnAnswerAmongItsOptions) {
  for (const std::string answer : {"2", "-1", "0.5"}) {
    EXPECT_EQ(quiz_mistakes(kMcq + R"("options": ["a", "b"], "answer": )" + answer + "}"),
              "E-quiz-form <" + answer +
                  "> \"answer\" is the index of the right option, counted from 0\n");
  }
  EXPECT_EQ(quiz_mistakes(kMcq + R"("options": ["a", "b"], "answer": [1]})"),
            "E-json-kind <[1]> \"answer\" is a list; expected a number\n");
}

TEST(Choice, OfSeveralHasAnAnswerAmongItsOptions) {
  const std::string options = kMulti + R"("options": ["a", "b"], "answer": )";
  for (const std::string answer : {"2", "-1", "0.5"}) {
    EXPECT_EQ(quiz_mistakes(options + "[0, " + answer + "]}"),
              "E-quiz-form <" + answer +
                  "> \"answer\" lists the indices of the right options, counted from 0\n");
  }
  EXPECT_EQ(quiz_mistakes(options + "1}"),
            "E-json-kind <1> \"answer\" is a number; expected a list of the right options' "
            "indices\n");
  EXPECT_EQ(quiz_mistakes(options + "[0, \"b\"]}"),
            "E-json-kind <\"b\"> \"answer\" is a string; expected the index of an option\n");
  EXPECT_EQ(quiz_mistakes(options + "[0, 1, 0]}"),
            "E-quiz-form <0> this option is in \"answer\" already\n");
  EXPECT_EQ(quiz_mistakes(options + "[]}"),
            "E-quiz-form <[]> \"answer\" is empty: no option is right | add an option that is "
            "right, such as \"none of these\"\n");
}

TEST(Option, IsTextThatMayHaveFeedback) {
  EXPECT_EQ(quiz_mistakes(kMcq + R"("options": ["a", 5], "answer": 0})"),
            "E-json-kind <5> \"options\" is a number; expected a string, or {\"text\": …, "
            "\"feedback\": …}\n");
  EXPECT_EQ(quiz_mistakes(kMcq + R"("options": ["a", {"feedback": "f"}], "answer": 0})"),
            "E-json-missing <{> this option has no \"text\" | add \"text\": …\n");
  EXPECT_EQ(quiz_mistakes(kMcq + R"("options": ["a", {"text": "b", "feed": "f"}], "answer": 0})"),
            "E-json-key <feed> an option has no key \"feed\" | known: text, feedback\n");
  EXPECT_EQ(quiz_mistakes(kOrder + R"("items": ["a", {"text": "b"}]})"),
            "E-json-kind <{\"text\": \"b\"}> \"items\" is an object; expected a string\n");
}

TEST(Option, IsOneOfSeveral) {
  EXPECT_EQ(quiz_mistakes(kMcq + R"("options": ["a"], "answer": 0})"),
            "E-quiz-form <[\"a\"]> \"options\" lists from 2 to 26, not 1\n");
  EXPECT_EQ(quiz_mistakes(kMulti + R"("options": [], "answer": [0]})"),
            "E-quiz-form <[]> \"options\" lists from 2 to 26, not 0\n");
  EXPECT_EQ(quiz_mistakes(kOrder + R"("items": ["a"]})"),
            "E-quiz-form <[\"a\"]> \"items\" lists from 2 to 26, not 1\n");
  std::string many;
  for (int i = 0; i < 27; ++i) many += (i > 0 ? ", " : "") + ('"' + std::to_string(i)) + '"';
  EXPECT_EQ(quiz_mistakes(kOrder + "\"items\": [" + many + "]}"),
            "E-quiz-form <[" + many + "]> \"items\" lists from 2 to 26, not 27\n");
}

TEST(Option, StandsOnce) {
  EXPECT_EQ(quiz_mistakes(kOrder + R"("items": ["a", "b", "*a*"]})"),
            "E-quiz-form <\"*a*\"> \"a\" stands twice in \"items\"\n");
  EXPECT_EQ(quiz_mistakes(kMcq + R"("options": ["a", "a"], "answer": 0})"),
            "E-quiz-form <\"a\"> \"a\" stands twice in \"options\"\n");
}

TEST(Tolerance, MayBeAPercentage) {
  for (const std::string tolerance : {"\"2.5%\"", "\"2.5 %\""}) {
    const ReadingOf reading = quiz_of(kNumeric + R"("answer": -40, "tol": )" + tolerance + "}");
    EXPECT_EQ(reading.mistakes(), "");
    EXPECT_EQ(reading.only<Quiz>().questions[0].tolerance.around(-40), 1);
  }
}

TEST(Tolerance, IsANumberOrAPercentage) {
  const std::string tolerance = kNumeric + R"("answer": 5, "tol": )";
  for (const std::string wrong :
       {"-1", "\"1\"", "\"%\"", "\"x%\"", "\"-1%\"", "\"inf%\"", "\"\""}) {
    EXPECT_EQ(quiz_mistakes(tolerance + wrong + "}"),
              "E-json-range <" + wrong +
                  "> \"tol\" says how far an answer may be off: a number, or a percentage: "
                  "\"1%\"\n");
  }
  EXPECT_EQ(quiz_mistakes(tolerance + "[1]}"),
            "E-json-kind <[1]> \"tol\" is a list; expected a number, or a percentage: \"1%\"\n");
  EXPECT_EQ(quiz_mistakes(kNumeric + R"("answer": 0, "tol": "1%"})"),
            "E-quiz-form <\"1%\"> a percentage of 0 leaves no room | write \"tol\" as a number\n");
}

}  // namespace
}  // namespace mjcourse
