#include "evaluate/scenes/assignment.h"

#include <gtest/gtest.h>

#include "evaluate/scenes/lab_text.h"

namespace mjcourse {
namespace {

TEST(Predict, IsMeasured) {
  const EvaluationOf found(lab_text(
      R"("predict": {"q": "?", "run": "data.qvel[0] = 2", "value": "data.qpos[0]", "seconds": 1.5})"));
  EXPECT_EQ(found.mistakes(), "");
  EXPECT_NEAR(found.result<LabResult>().predicted.value(), 3, 1e-9);
}

TEST(Predict, FailsWhereItsScriptOrValueDoes) {
  const auto predict = [](const std::string& members) {
    return rehearsed_mistakes(R"("predict": {"q": "?", "seconds": 1, )" + members + "}");
  };
  EXPECT_EQ(predict(R"("value": "data.qpso[0]")"),
            "E-script-name <qpso> data.qpso does not exist | did you mean `data.qpos`?\n");
  EXPECT_EQ(predict(R"("value": "1 / data.qvel[0]")"),
            "E-script-value <1 / data.qvel[0]> the value is Infinity, not a finite number | "
            "look for a division by 0, or a root or a logarithm of a negative number\n");
  EXPECT_EQ(predict(R"("value": "data.time", "run": "data.qvel[0] = 1e12")"),
            "E-lab-simulation <data.qvel[0] = 1e12> after the prediction's script: the simulation "
            "diverged at t = 0 s: qvel[0] of joint `free` is infinite, not a number, or huge | a "
            "smaller time step, or a gentler push\n");
}

std::string goal_mistakes(const std::string& done, const std::string& solution) {
  return rehearsed_mistakes(R"("goal": {"text": "t", "done": ")" + done + R"(", "solution": {)" +
                            solution + "}}");
}

TEST(Goal, IsReachedByItsSolution) {
  EXPECT_EQ(goal_mistakes("data.qpos[0] > 1", R"("run": "data.qvel[0] = 2", "seconds": 0.6)"), "");
  EXPECT_EQ(goal_mistakes("data.qvel[0] > 1", R"("run": "data.qvel[0] = 2")"), "");
  EXPECT_EQ(goal_mistakes("data.qpos[0] > 1", R"("run": "data.qvel[0] = 2", "seconds": 0.4)"),
            "E-lab-goal <data.qvel[0] = 2> the solution does not reach the goal within 0.4 s | "
            "fix the solution, give it more \"seconds\", or ask for less in \"done\"\n");
  EXPECT_EQ(goal_mistakes("data.qpos[0] > 1", R"("run": "data.qvel[0] = 2")"),
            "E-lab-goal <data.qvel[0] = 2> the solution does not reach the goal | fix the "
            "solution, give it more \"seconds\", or ask for less in \"done\"\n");
}

// It need not last: that it was so once is enough.
TEST(Goal, MayBeReachedInPassing) {
  EXPECT_EQ(goal_mistakes("Math.abs(data.time - 0.5) < 0.01",
                          R"("run": "data.qvel[0] = 2", "seconds": 1)"),
            "");
}

TEST(Goal, IsOpenAtRest) {
  EXPECT_EQ(
      goal_mistakes("data.qpos[2] > 0", R"("run": "data.qvel[0] = 2")"),
      "E-lab-goal <data.qpos[2] > 0> the goal is already reached at the start | ask for something "
      "that is not so from the start\n");
}

TEST(Goal, IsTrueOrFalse) {
  EXPECT_EQ(goal_mistakes("data.qpos[0]", R"("run": "data.qvel[0] = 2")"),
            "E-script-value <data.qpos[0]> the value is 0, not true or false\n");
}

constexpr const char* kHeavy = R"(<mujoco><worldbody>
  <body name="ball"><freejoint name="free"/><geom size="0.1" mass="5"/></body>
</worldbody></mujoco>)";

std::string editable_mistakes(const std::string& task, const std::string& done,
                              const std::string& solution) {
  return rehearsed_mistakes(R"("editable": {"tasks": [{"q": "?", "value": ")" + task + R"("}]},
      "goal": {"text": "t", "done": ")" +
                                done + R"(", "solution": {"model": ")" + solution + "\"}}",
                            {{"models/heavy.xml", kHeavy}});
}

TEST(Editable, IsSolvedByAModel) {
  EXPECT_EQ(editable_mistakes("model.nq", "model.body_mass[1] === 5", "heavy"), "");
  EXPECT_EQ(editable_mistakes("model.nq", "model.body_mass[1] === 6", "heavy"),
            "E-lab-goal <heavy> the solution does not reach the goal | fix the solution, give it "
            "more \"seconds\", or ask for less in \"done\"\n");
  EXPECT_EQ(editable_mistakes("model.nq", "model.body_mass[1] === 5", "heavi"),
            "E-model-unknown <heavi> there is no model `heavi` in models/ | did you mean "
            "`heavy`?\n");
}

// A task is computed for the lab's own model and for the solution's, which has no cart.
TEST(Editable, HasTasksThatEitherModelAnswers) {
  EXPECT_EQ(editable_mistakes("model.nqq", "model.body_mass[1] === 5", "heavy"),
            "E-script-name <nqq> model.nqq does not exist | did you mean `model.nq`?\n");
  EXPECT_EQ(editable_mistakes("body('cart').mass", "model.body_mass[1] === 5", "heavy"),
            "E-script-name <cart> no body is named `cart` | known: world, ball\n");
}

}  // namespace
}  // namespace mjcourse
