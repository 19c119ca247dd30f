#include "evaluate/answers/inline_value.h"

#include <gtest/gtest.h>

#include "evaluate/evaluation_of.h"

namespace mjcourse {
namespace {

// Writes by itself what the helper header would, which takes long to compile.
const std::string kProgram = R"p(#include <cstdlib>
#include <fstream>
int main() {
  std::ofstream(std::getenv("MJCOURSE_RECORDS")) << R"({"result": "ratio", "value": 0.99958}
{"result": "word", "value": "a < b"}
{"result": "pose", "value": [1, 2]}
{"result": "key", "value": 9007199254740993}
{"result": "low", "value": -9223372036854775808}
{"result": "hash", "value": 18446744073709551615}
)";
}
)p";

// The lesson's line 4 is `line`; an example stands below.
EvaluationOf quoting(const std::string& line) {
  return EvaluationOf(line + "\n\n```cpp file=examples/tell.cpp\n" + kProgram + "```\n",
                      {{"examples/tell.cpp", kProgram}});
}

std::string text_of(const std::string& code) {
  const EvaluationOf found("`" + code + "`\n");
  return found.mistakes().empty() ? found.result<ValueResult>().text : found.mistakes();
}

TEST(InlineValue, IsComputedOnAModel) {
  const EvaluationOf found("`{ball} model.nq`\n");
  EXPECT_EQ(found.mistakes(), "");
  EXPECT_EQ(found.result<ValueResult>().text, "8");
  EXPECT_EQ(found.result<ValueResult>().origin, "model.nq of ball.xml");
  EXPECT_EQ(found.tally().values, 1);
  EXPECT_EQ(text_of("{ball} qpos('slide')"), "0");
  EXPECT_EQ(text_of("{ball} body('ball').xpos[2]"), "1");
  EXPECT_EQ(text_of("{ball} 'a' + model.nv"), "a7");
}

TEST(InlineValue, IsPrintedShortlyOrAsAsked) {
  EXPECT_EQ(text_of("{ball} 1 / 3"), "0.333333");
  EXPECT_EQ(text_of("{ball} 2 ** 53 - 1"), "9007199254740991");
  EXPECT_EQ(text_of("{ball} 1e16"), "1e+16");
  EXPECT_EQ(text_of("{ball} 123456789"), "123456789");
  EXPECT_EQ(text_of("{ball} -0"), "0");
  EXPECT_EQ(text_of("{ball} -0.001 :.2f"), "0.00");
  EXPECT_EQ(text_of("{ball} -0.01 :.2f"), "-0.01");
  EXPECT_EQ(text_of("{ball} 2 / 3 :.4f"), "0.6667");
  EXPECT_EQ(text_of("{ball} 2000 :.2e"), "2.00e+03");
  EXPECT_EQ(text_of("{ball} 7 :d"), "7");
}

TEST(InlineValue, IsWhatAnExampleReported) {
  const EvaluationOf found = quoting("`{tell} ratio :.4f`");
  EXPECT_EQ(found.mistakes(), "");
  EXPECT_EQ(found.result<ValueResult>().text, "0.9996");
  EXPECT_EQ(found.result<ValueResult>().origin, "ratio of tell.cpp");
  EXPECT_EQ(quoting("`{tell} word`").result<ValueResult>().text, "a < b");
}

TEST(InlineValue, HasAllDigitsOfAWholeNumber) {
  const auto text = [](const std::string& code) {
    return quoting("`{tell} " + code + "`").result<ValueResult>().text;
  };
  EXPECT_EQ(text("key"), "9007199254740993");
  EXPECT_EQ(text("key :d"), "9007199254740993");
  EXPECT_EQ(text("key :.1f"), "9007199254740993.0");
  EXPECT_EQ(text("key :.3e"), "9.007e+15");
  EXPECT_EQ(text("low"), "-9223372036854775808");
  EXPECT_EQ(text("hash"), "18446744073709551615");
}

// What is wrong with a code span in line 4, from its message on, without place and excerpt.
std::string mistake(const std::string& code) {
  const EvaluationOf found = quoting("`" + code + "`");
  std::string text;
  for (const Diagnostic& d : found.diagnostics()) {
    const auto column = static_cast<std::size_t>(d.place.column - 1);
    text += d.id + " <" + d.place.excerpt.substr(column, static_cast<std::size_t>(d.place.width)) +
            "> " + d.message + (d.cure.empty() ? "" : " | " + d.cure) + "\n";
  }
  return text;
}

TEST(InlineValue, NamesWhatThereIs) {
  EXPECT_EQ(mistake("{bal} model.nq"),
            "E-value-source <bal> there is no model or example `bal` | did you mean `ball`?\n");
  EXPECT_EQ(mistake("{tel} ratio"),
            "E-value-source <tel> there is no model or example `tel` | did you mean `tell`?\n");
  EXPECT_EQ(mistake("{tell} rato"),
            "E-example-result <rato> the example `tell` reports no result `rato` | did you mean "
            "`ratio`?\n");
  EXPECT_EQ(mistake("{ball} model.nqq"),
            "E-script-name <nqq> model.nqq does not exist | did you mean `model.nq`?\n");
}

TEST(InlineValue, IsOneNumberOrAText) {
  EXPECT_EQ(mistake("{ball} qpos('free')"),
            "E-value-kind <qpos('free')> this is a vector of 7 numbers; the text takes one "
            "| choose one of them, as `qpos('hinge')[0]`\n");
  EXPECT_EQ(mistake("{tell} pose"),
            "E-value-kind <pose> this is a vector of 2 numbers; the text takes one | report "
            "the one that the text speaks of by a name of its own\n");
  EXPECT_EQ(mistake("{ball} model.nq > 3"),
            "E-value-kind <model.nq > 3> this is true or false; the text takes a number\n");
  EXPECT_EQ(mistake("{tell} ratio :d"),
            "E-value-format <d> `:d` prints whole numbers, and this is 0.99958 | round it by hand, "
            "or use `:.0f`\n");
  EXPECT_EQ(mistake("{ball} 2 ** 53 :d"),
            "E-value-format <d> `:d` prints whole numbers below 2^53, and this is 9.0072e+15 | "
            "round it by hand, or use `:.0f`\n");
  EXPECT_EQ(mistake("{tell} word :.2f"),
            "E-value-format <.2f> this is a text, which takes no format\n");
}

TEST(InlineValue, OfAFailedExampleIsNoSecondMistake) {
  const std::string code = "int main() { return 1; }\n";
  const EvaluationOf found("`{a} x`\n\n```cpp file=examples/a.cpp\n" + code + "```\n",
                           {{"examples/a.cpp", code}});
  ASSERT_EQ(found.diagnostics().size(), 1u) << found.mistakes();
  EXPECT_EQ(found.diagnostics()[0].id, "E-example-exit");
  EXPECT_EQ(found.tally().values, 0);
}

TEST(InlineValue, CannotChooseBetweenAModelAndAnExample) {
  const std::string code = "int main() {}\n";
  const EvaluationOf found("`{ball} x`\n\n```cpp file=examples/ball.cpp\n" + code + "```\n",
                           {{"examples/ball.cpp", code}});
  EXPECT_EQ(found.mistakes(),
            "content/1-a/1.1-x.md:4:3: error: `ball` is a model and an example [E-value-source]\n"
            "  4 | `{ball} x`\n"
            "    |   ^~~~\n"
            "  cure: give one another name\n");
}

TEST(InlineValue, MustBeReportedByItsExample) {
  const std::string code = "int main() {}\n";
  const EvaluationOf found("`{a} x`\n\n```cpp file=examples/a.cpp\n" + code + "```\n",
                           {{"examples/a.cpp", code}});
  ASSERT_EQ(found.diagnostics().size(), 1u);
  EXPECT_EQ(found.diagnostics()[0].cure, "report it there: `result(\"x\", …)`");
}

// A question answered with `answer` and proved by a result of the example.
std::string asked(const std::string& answer, const std::string& result) {
  const EvaluationOf found = quoting(
      "```quiz\n{\"id\": \"q\", \"questions\": [{\"kind\": \"numeric\", \"q\": \"?\", "
      "\"answer\": " +
      answer + ", \"tol\": 0.001,\n\"verify\": [{\"example\": \"tell\", \"value\": \"" + result +
      "\"}]}]}\n```");
  if (!found.mistakes().empty()) return found.mistakes();
  const QuestionResult& question = found.result<QuizResult>().questions.at(0);
  const ProofResult& proof = question.proofs.at(0);
  return proof.built + " | " + proof.expression + " | " + proof.value +
         (question.by_program ? " by program" : "");
}

TEST(ProofByExample, IsAResultThatItReported) {
  EXPECT_EQ(asked("1", "ratio"), "tell.cpp | ratio | 0.99958 by program");
  EXPECT_EQ(
      asked("2", "ratio"),
      R"(content/1-a/1.1-x.md:5:67: error: the answer is given as 2, but the build finds 0.99958 [E-quiz-answer]
  5 | {"id": "q", "questions": [{"kind": "numeric", "q": "?", "answer": 2, "tol": 0.001,
    |                                                                   ^
  note: content/1-a/1.1-x.md:6:42: `ratio` is 0.99958 for tell
  6 | "verify": [{"example": "tell", "value": "ratio"}]}]}
    |                                          ^~~~~
)");
}

TEST(ProofByExample, NeedsANumberThatIsThere) {
  EXPECT_EQ(
      asked("1", "ratoi"),
      R"(content/1-a/1.1-x.md:6:42: error: the example `tell` reports no result `ratoi` [E-example-result]
  6 | "verify": [{"example": "tell", "value": "ratoi"}]}]}
    |                                          ^~~~~
  cure: did you mean `ratio`?
)");
  EXPECT_EQ(asked("1", "pose"),
            R"(content/1-a/1.1-x.md:6:42: error: the result `pose` is not a number [E-proof-value]
  6 | "verify": [{"example": "tell", "value": "pose"}]}]}
    |                                          ^~~~
  cure: report the number by itself
)");
}

}  // namespace
}  // namespace mjcourse
