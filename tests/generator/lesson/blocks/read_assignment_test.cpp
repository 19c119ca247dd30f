#include "lesson/blocks/read_assignment.h"

#include <gtest/gtest.h>

#include "lesson/lab_reading.h"

namespace mjcourse {
namespace {

TEST(Predict, IsRead) {
  const ReadingOf reading = lab_with(
      R"("predict": {"q": "How $x$?", "value": "v", "seconds": 2.5, "run": ["a", "b"], "tol": 0.1,
                     "digits": 1, "unit": "m", "explain": "So."})");
  EXPECT_EQ(reading.mistakes(), "");
  const Lab::Predict& predict = reading.only<Lab>().predict.value();
  EXPECT_EQ(plain_text(predict.question.get()), "How x?");
  EXPECT_EQ(plain_text(predict.explanation.get()), "So.");
  EXPECT_EQ(predict.value.text + " " + predict.run.text + " " + predict.unit, "v a\nb m");
  EXPECT_EQ(predict.seconds, 2.5);
  EXPECT_EQ(predict.tolerance, 0.1);
  EXPECT_EQ(predict.digits, 1);
}

TEST(Predict, NeedsAQuestionAValueAndATime) {
  EXPECT_EQ(lab_mistakes(R"("predict": {})"),
            "E-json-missing <{> this prediction has no \"q\" | add \"q\": …\n"
            "E-json-missing <{> this prediction has no \"value\" | add \"value\": …\n"
            "E-json-missing <{> this prediction has no \"seconds\" | add \"seconds\": …\n");
  for (const std::string seconds : {"0", "-1", "101"}) {
    EXPECT_EQ(
        lab_mistakes(R"("predict": {"q": "?", "value": "v", "seconds": )" + seconds + "}"),
        "E-json-range <" + seconds + "> \"seconds\" is simulated time: more than 0, at most 100\n");
  }
  EXPECT_EQ(lab_mistakes(R"("predict": {"q": "?", "value": "v", "seconds": 1, "tol": -1})"),
            "E-json-range <-1> \"tol\" is how far off a number may be: 0 or more\n");
}

TEST(Goal, IsRead) {
  const ReadingOf reading = lab_with(
      R"("goal": {"text": "Lift it.", "done": "d", "solution": {"run": "r", "seconds": 3}})");
  EXPECT_EQ(reading.mistakes(), "");
  const Lab::Goal& goal = reading.only<Lab>().goal.value();
  EXPECT_EQ(plain_text(goal.text.get()), "Lift it.");
  EXPECT_EQ(goal.done.text + " " + goal.solution_run.text, "d r");
  EXPECT_EQ(goal.solution_seconds, 3);
}

TEST(Goal, NeedsASolution) {
  const auto of_goal = [](const std::string& more) {
    return lab_mistakes(R"("goal": {"text": "t", "done": "d")" + more + "}");
  };
  EXPECT_EQ(of_goal(""),
            "E-json-missing <{> nobody knows whether this goal can be reached: it has no "
            "\"solution\" | add \"solution\": {\"run\": …, \"seconds\": …}\n");
  EXPECT_EQ(of_goal(R"(, "solution": {})"),
            "E-lab-goal <{> a solution is a script \"run\", a \"model\", or MJCF to \"insert\" | "
            "write one of them\n");
  EXPECT_EQ(of_goal(R"(, "solution": {"model": "m"})"),
            "E-lab-goal <m> a model can only be the solution where the reader edits one | write "
            "the solution as a script \"run\", or make the lab \"editable\"\n");
  EXPECT_EQ(of_goal(R"(, "solution": {"run": "r", "seconds": 101})"),
            "E-json-range <101> \"seconds\" is simulated time: from 0 to 100\n");
  EXPECT_EQ(
      of_goal(R"(, "solution": {"run": "r", "before": "<site"})"),
      "E-lab-goal <<site> \"before\" says where MJCF is inserted, and there is none | write it as "
      "\"insert\", or leave \"before\" out\n");
  EXPECT_EQ(of_goal(R"(, "solution": {"run": "r", "model": "m"}}, "editable": {"tasks": 1)"),
            "E-json-kind <1> \"tasks\" is a number; expected a list\n"
            "E-lab-goal <{> a solution is a script \"run\", a \"model\", or MJCF to \"insert\" | "
            "write one of them\n");
}

TEST(Editable, IsALabOrHasTasks) {
  EXPECT_TRUE(lab_with(R"("editable": true)").only<Lab>().editable);
  EXPECT_FALSE(lab_with(R"("editable": false)").only<Lab>().editable);
  const ReadingOf reading = lab_with(
      R"("editable": {"tasks": [{"q": "?", "value": "v", "tol": 0.5, "unit": "kg"}]},
         "goal": {"text": "t", "done": "d", "solution": {"model": "m"}})");
  EXPECT_EQ(reading.mistakes(), "");
  const auto& lab = reading.only<Lab>();
  EXPECT_TRUE(lab.editable);
  EXPECT_EQ(lab.tasks.at(0).value.text + " " + lab.tasks[0].unit, "v kg");
  EXPECT_EQ(lab.tasks[0].tolerance, 0.5);
  EXPECT_EQ(lab.goal.value().solution_model.text, "m");
}

TEST(Editable, RefusesWhatIsNeither) {
  EXPECT_EQ(lab_mistakes(R"("editable": "yes")"),
            "E-json-kind <\"yes\"> \"editable\" is a string; expected true, or an object with "
            "\"tasks\"\n");
  EXPECT_EQ(lab_mistakes(R"("editable": {"tasks": []})"),
            "E-json-missing <[]> \"tasks\" is empty | add a task: {\"q\": …, \"value\": …}, or "
            "write true\n");
  EXPECT_EQ(lab_mistakes(R"("editable": {"tasks": [{"q": "?"}]})"),
            "E-json-missing <{> this task has no \"value\" | add \"value\": …\n");
}

}  // namespace
}  // namespace mjcourse
