#include "evaluate/answers/question.h"

#include <gtest/gtest.h>

#include "evaluate/evaluation_of.h"

namespace mjcourse {
namespace {

// A quiz of one question; its proofs stand in line 6.
std::string number(const std::string& answer, const std::string& proofs) {
  return "```quiz\n{\"id\": \"q\", \"questions\": [{\"kind\": \"numeric\", \"answer\": " + answer +
         ", \"q\": \"?\", \"verify\": [\n" + proofs + "]}]}\n```\n";
}
std::string choice(const std::string& answer, const std::string& proofs) {
  return "```quiz\n{\"id\": \"q\", \"questions\": [{\"kind\": \"mcq\", \"answer\": " + answer +
         ", \"q\": \"?\", \"options\": [\"one\", \"$two$\"], \"verify\": [\n" + proofs +
         "]}]}\n```\n";
}

std::string several(const std::string& answer, const std::string& proofs) {
  return "```quiz\n{\"id\": \"q\", \"questions\": [{\"kind\": \"multi\", \"answer\": " + answer +
         ", \"q\": \"?\", \"options\": [\"one\", \"two\", \"three\"], \"verify\": [\n" + proofs +
         "]}]}\n```\n";
}
std::string order(const std::string& proofs) {
  return "```quiz\n{\"id\": \"q\", \"questions\": [{\"kind\": \"order\", \"q\": \"?\", "
         "\"items\": [\"one\", \"`two`\", \"three\"], \"verify\": [\n" +
         proofs + "]}]}\n```\n";
}

// "built | expression | value" of each proof of the only question.
std::string proofs_of(const EvaluationOf& evaluation) {
  std::string text = evaluation.mistakes();
  for (const ProofResult& proof : evaluation.result<QuizResult>().questions.at(0).proofs) {
    text += proof.built + " | " + proof.expression + " | " + proof.value + "\n";
  }
  return text;
}

TEST(Question, IsProvedByBuildingWhatItDescribes) {
  const EvaluationOf found(number("8", R"(
    {"model": "ball", "value": "model.nq"},
    {"joints": {"hinge": 1, "free": 1}, "value": "model.nq"},
    {"joints": {"ball": 2}, "value": "model.nq"},
    {"mjcf": ["<mujoco>", "</mujoco>"], "run": ["const a = model.nq;"], "value": "a + 8"},
    {"model": "ball", "value": "model.nv", "equals": 7})"));
  EXPECT_EQ(proofs_of(found),
            "ball.xml | model.nq | 8\n"
            "a model with 1 hinge and 1 free joints | model.nq | 8\n"
            "a model with 2 ball joints | model.nq | 8\n"
            "the model in the question | a + 8 | 8\n"
            "ball.xml | model.nv | 7\n");
  EXPECT_TRUE(found.result<QuizResult>().questions[0].proved);
  EXPECT_EQ(found.tally().answers_proved, 1);
}

TEST(Question, MayRunAScriptAndTheClockFirst) {
  EXPECT_EQ(proofs_of(EvaluationOf(number(
                "2.5", R"({"model": "ball", "run": "data.qvel[0] = 2; model.opt.gravity[2] = 0",
                           "seconds": 1.25, "value": "qpos('free')[0]"})"))),
            "ball.xml | qpos('free')[0] | 2.5\n");
}

TEST(Question, AllowsForItsToleranceAndForBinary) {
  EXPECT_EQ(
      evaluated_mistakes(number("0.1", R"j({"model": "ball", "value": "data.time + 0.3 - 0.2"})j")),
      "");
  const auto tolerant = [](const std::string& answer, const std::string& tolerance) {
    std::string question = number(answer, R"j({"model": "ball", "value": "model.nq"})j");
    question.insert(question.find("\"q\": \"?\""), "\"tol\": " + tolerance + ", ");
    return evaluated_mistakes(question);
  };
  EXPECT_EQ(tolerant("8.5", "0.5"), "");
  EXPECT_EQ(tolerant("10", "\"20%\""), "");
  EXPECT_NE(tolerant("10", "\"19%\""), "");
  EXPECT_EQ(tolerant("-10", "180"), "");
}

TEST(Question, HoldsSmallAndWholeNumbersToAllTheirDigits) {
  const auto of = [](const std::string& answer, const std::string& value) {
    const std::string mistakes = evaluated_mistakes(
        number(answer, R"({"model": "ball", "value": "data.time + )" + value + "\"}"));
    const std::size_t message = mistakes.find("the answer"), end = mistakes.find(" [");
    return message == mistakes.npos ? mistakes : mistakes.substr(message, end - message);
  };
  EXPECT_EQ(of("1.6e-19", "2 * 0.8e-19"), "");
  EXPECT_EQ(of("1.6e-19", "5e-19"), "the answer is given as 1.6e-19, but the build finds 5e-19");
  EXPECT_EQ(of("0", "1e-13"), "the answer is given as 0, but the build finds 1e-13");
  EXPECT_EQ(of("1000000000001", "1e12 + 2"),
            "the answer is given as 1000000000001, but the build finds 1000000000002");
  EXPECT_EQ(of("0.3", "0.30000000001"),
            "the answer is given as 0.3, but the build finds 0.30000000001");
}

TEST(Question, WithAWrongAnswerIsAnError) {
  const EvaluationOf found(number("9", R"({"model": "ball", "value": "model.nq"})"));
  EXPECT_EQ(
      found.mistakes(),
      R"(content/1-a/1.1-x.md:5:57: error: the answer is given as 9, but the build finds 8 [E-quiz-answer]
  5 | {"id": "q", "questions": [{"kind": "numeric", "answer": 9, "q": "?", "verify": [
    |                                                         ^
  note: content/1-a/1.1-x.md:6:29: `model.nq` is 8 for ball
  6 | {"model": "ball", "value": "model.nq"}]}]}
    |                             ^~~~~~~~
)");
  EXPECT_FALSE(found.result<QuizResult>().questions[0].proved);
  EXPECT_EQ(found.tally().answers_proved + found.tally().answers_asserted, 0);
}

TEST(Question, WithAProofThatFindsSomethingElseIsAnError) {
  EXPECT_EQ(
      evaluated_mistakes(number("8", R"({"model": "ball", "value": "model.nv", "equals": 6})")),
      R"(content/1-a/1.1-x.md:6:1: error: the proof expects 6, but finds 7 [E-proof-value]
  6 | {"model": "ball", "value": "model.nv", "equals": 6}]}]}
    | ^~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~
  note: content/1-a/1.1-x.md:6:29: `model.nv` is 7 for ball
  6 | {"model": "ball", "value": "model.nv", "equals": 6}]}]}
    |                             ^~~~~~~~
)");
}

TEST(Question, IsOnlyAssertedWithoutAProofOfItsAnswer) {
  for (const std::string proofs : {"", R"({"because": "a convention"})",
                                   R"({"model": "ball", "value": "model.nv", "equals": 7})"}) {
    const EvaluationOf found(number("8", proofs));
    EXPECT_EQ(found.mistakes(), "");
    EXPECT_FALSE(found.result<QuizResult>().questions[0].proved) << proofs;
    EXPECT_EQ(found.tally().answers_asserted, 1);
  }
}

TEST(Choice, IsProvedWhenOnlyTheRightOptionHolds) {
  EXPECT_EQ(proofs_of(EvaluationOf(
                choice("1", R"({"model": "ball", "options": ["false", "model.nq == 8"]})"))),
            "ball.xml |  | 1 (\"two\")\n");
}

TEST(Choice, OfWhichTwoOptionsHoldIsAnError) {
  EXPECT_EQ(
      evaluated_mistakes(choice("1", R"({"model": "ball", "options": ["true", "true"]})")),
      R"(content/1-a/1.1-x.md:5:53: error: the answer is given as option 1 ("two"), but the build finds 0 ("one") and 1 ("two") [E-quiz-answer]
  5 | …"questions": [{"kind": "mcq", "answer": 1, "q": "?", "options": ["one", "$two$"], "verify": [
    |                                          ^
  note: content/1-a/1.1-x.md:6:32: this holds for ball
  6 | {"model": "ball", "options": ["true", "true"]}]}]}
    |                                ^~~~
)");
}

TEST(Choice, OfWhichNoOptionHoldsIsAnError) {
  EXPECT_EQ(
      evaluated_mistakes(choice("1", R"({"model": "ball", "options": ["false", "false"]})")),
      R"(content/1-a/1.1-x.md:5:53: error: the answer is given as option 1 ("two"), but the build finds no option [E-quiz-answer]
  5 | …"questions": [{"kind": "mcq", "answer": 1, "q": "?", "options": ["one", "$two$"], "verify": [
    |                                          ^
  note: content/1-a/1.1-x.md:6:41: this does not hold for ball
  6 | {"model": "ball", "options": ["false", "false"]}]}]}
    |                                         ^~~~~
)");
}

TEST(Choice, StartsAfreshForEachOption) {
  EXPECT_EQ(evaluated_mistakes(
                choice("1", R"j({"model": "ball", "run": "step(1)", "options": ["data.time > 0.003",
                                                                       "data.time > 0.001"]})j")),
            "");
}

TEST(Several, AreProvedWhenExactlyTheyHold) {
  EXPECT_EQ(proofs_of(EvaluationOf(
                several("[2, 0]", R"({"model": "ball", "options": ["model.nv == 7", "model.nq == 7",
                                            "model.nq == 8"]})"))),
            "ball.xml |  | 0 (\"one\") and 2 (\"three\")\n");
}

TEST(Several, OfWhichOneMoreHoldsIsAnError) {
  EXPECT_EQ(
      evaluated_mistakes(
          several("[0]", R"({"model": "ball", "options": ["true", "false", "true"]})")),
      R"(content/1-a/1.1-x.md:5:55: error: the answer is given as option 0 ("one"), but the build finds 0 ("one") and 2 ("three") [E-quiz-answer]
  5 | …: [{"kind": "multi", "answer": [0], "q": "?", "options": ["one", "two", "three"], "verify": [
    |                                 ^~~
  note: content/1-a/1.1-x.md:6:49: this holds for ball
  6 | {"model": "ball", "options": ["true", "false", "true"]}]}]}
    |                                                 ^~~~
)");
}

TEST(Several, OfWhichOneDoesNotHoldIsAnError) {
  EXPECT_EQ(
      evaluated_mistakes(
          several("[0, 1, 2]", R"({"model": "ball", "options": ["true", "false", "true"]})")),
      R"(content/1-a/1.1-x.md:5:55: error: the answer is given as options 0 ("one"), 1 ("two") and 2 ("three"), but the build finds 0 ("one") and 2 ("three") [E-quiz-answer]
  5 | …: [{"kind": "multi", "answer": [0, 1, 2], "q": "?", "options": ["one", "two", "three"], "veri…
    |                                 ^~~~~~~~~
  note: content/1-a/1.1-x.md:6:40: this does not hold for ball
  6 | {"model": "ball", "options": ["true", "false", "true"]}]}]}
    |                                        ^~~~~
)");
}

TEST(Order, IsProvedByNumbersThatGrow) {
  EXPECT_EQ(proofs_of(EvaluationOf(order(
                R"({"model": "ball", "run": "step(1);", "values": ["-1", "data.time", "model.nq"]},
                   {"joints": {"free": 1}, "value": "model.nv", "equals": 6})"))),
            "ball.xml |  | -1 < 0.002 < 8\n"
            "a model with 1 free joint | model.nv | 6\n");
}

TEST(Order, StartsAfreshForEachItem) {
  EXPECT_EQ(proofs_of(EvaluationOf(order(
                R"({"model": "ball", "run": "step(1);", "values": ["data.time", "2 * data.time",
                    "3 * data.time"]})"))),
            "ball.xml |  | 0.002 < 0.004 < 0.006\n");
}

TEST(Order, OfWhichTheNumbersDoNotGrowIsAnError) {
  EXPECT_EQ(
      evaluated_mistakes(order(R"({"joints": {"ball": 1}, "values": ["3", "model.nq", "-0.5"]})")),
      R"(content/1-a/1.1-x.md:5:65: error: the order is given as "one", "two", "three", but the build finds "three", "one", "two" [E-quiz-answer]
  5 | …q", "questions": [{"kind": "order", "q": "?", "items": ["one", "`two`", "three"], "verify": [
    |                                                          ^~~~~
  note: content/1-a/1.1-x.md:6:37: in that order they are -0.5, 3 and 4 for 1 ball joint
  6 | {"joints": {"ball": 1}, "values": ["3", "model.nq", "-0.5"]}]}]}
    |                                     ^
)");
}

TEST(Order, OfTwoEqualNumbersIsAnError) {
  EXPECT_EQ(
      evaluated_mistakes(order(R"({"model": "ball", "values": ["1", "0.1 + 0.2", "0.3"]})")),
      R"(content/1-a/1.1-x.md:5:72: error: the order is given as "one", "two", "three", but the build finds "three" and "two" equal [E-quiz-answer]
  5 | …q", "questions": [{"kind": "order", "q": "?", "items": ["one", "`two`", "three"], "verify": [
    |                                                                 ^~~~~~~
  note: content/1-a/1.1-x.md:6:36: both are 0.3 for ball
  6 | {"model": "ball", "values": ["1", "0.1 + 0.2", "0.3"]}]}]}
    |                                    ^~~~~~~~~
)");
}

TEST(Order, OfSmallNumbersIsOne) {
  EXPECT_EQ(proofs_of(EvaluationOf(
                order(R"({"model": "ball", "values": ["data.time + 1e-15", "2e-15", "3e-15"]})"))),
            "ball.xml |  | 1e-15 < 2e-15 < 3e-15\n");
}

TEST(Order, IsAssertedWithoutAProofOfIt) {
  const EvaluationOf found(order(R"({"model": "ball", "value": "model.nv", "equals": 7})"));
  EXPECT_EQ(found.mistakes(), "");
  EXPECT_EQ(found.tally().answers_asserted, 1);
}

TEST(Proof, ShowsAMistakeInItsScriptAtItsLine) {
  EXPECT_EQ(evaluated_mistakes(number("8", R"({"model": "ball", "value": "model.nq", "run": [
  "step(1);",
  "  data.qpso[0] = 1;"]})")),
            R"(content/1-a/1.1-x.md:8:11: error: data.qpso does not exist [E-script-name]
  8 |   "  data.qpso[0] = 1;"]}]}]}
    |           ^~~~
  cure: did you mean `data.qpos`?
)");
}

TEST(Proof, ShowsAMistakeInItsValueThere) {
  EXPECT_EQ(
      evaluated_mistakes(
          number("8", R"j({"model": "ball", "run": "step(1)", "value": "data.\u0071pos[99]"})j")),
      R"j(content/1-a/1.1-x.md:6:47: error: data.qpos[99] is out of range 0..7 [E-script-range]
  6 | {"model": "ball", "run": "step(1)", "value": "data.\u0071pos[99]"}]}]}
    |                                               ^~~~~~~~~~~~~~~~~~
)j");
}

TEST(Proof, FindsAFiniteNumber) {
  EXPECT_EQ(
      evaluated_mistakes(number("8", R"({"model": "ball", "value": "0/0"})")),
      R"(content/1-a/1.1-x.md:6:29: error: the value is NaN, not a finite number [E-script-value]
  6 | {"model": "ball", "value": "0/0"}]}]}
    |                             ^~~
  cure: look for a division by 0, or a root or a logarithm of a negative number
)");
}

TEST(Proof, DoesNotTrustASimulationThatDiverged) {
  EXPECT_EQ(
      evaluated_mistakes(number(
          "8", R"({"model": "ball", "run": "data.qvel[2] = 1e300", "seconds": 1, "value": "8"})")),
      R"(content/1-a/1.1-x.md:6:27: error: the simulation diverged at t = 0.002 s: qvel[2] of joint `free` is infinite, not a number, or huge [E-script-mujoco]
  6 | {"model": "ball", "run": "data.qvel[2] = 1e300", "seconds": 1, "value": "8"}]}]}
    |                           ^~~~~~~~~~~~~~~~~~~~
)");
}

}  // namespace
}  // namespace mjcourse
