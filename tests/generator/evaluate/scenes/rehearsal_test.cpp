#include "evaluate/scenes/rehearsal.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "evaluate/scenes/lab_text.h"

namespace mjcourse {
namespace {

std::string shown(const ControlValue& value) {
  std::ostringstream text;
  if (const auto* on = std::get_if<bool>(&value)) text << (*on ? "on" : "off");
  if (const auto* option = std::get_if<int>(&value)) text << "#" << *option;
  if (const auto* number = std::get_if<double>(&value)) text << *number;
  return text.str();
}

// A line for each run: its control and value, and what the first readout said at each reading.
std::string runs(const std::string& members) {
  const EvaluationOf found(lab_text(members));
  if (!found.mistakes().empty()) return found.mistakes();
  std::ostringstream text;
  for (const LabRunResult& run : found.result<LabResult>().runs) {
    text << (run.control ? std::to_string(*run.control) : "-") << " " << shown(run.value) << ":";
    for (const LabReading& reading : run.readings) {
      text << " " << reading.steps << "=" << reading.values.at(0);
    }
    text << "\n";
  }
  return text.str();
}

TEST(Rehearsal, UsesEachControlInEachOfItsValues) {
  EXPECT_EQ(runs(R"j("readouts": [{"label": "v", "expr": "data.qvel[0]"}], "controls": [
      {"type": "button", "label": "B", "run": "data.qvel[0] = 1"},
      {"type": "slider", "label": "S", "bind": "data.qvel[0]", "min": -2, "max": 2},
      {"type": "toggle", "label": "T", "on": "data.qvel[0] += 3", "off": "data.qvel[0] += 10"},
      {"type": "select", "label": "C", "options": [{"label": "a", "run": "data.qvel[0] = 4"},
                                                   {"label": "b", "run": ""}]}])j"),
            "- : 0=0 250=0 500=0 1000=0\n"
            "0 : 0=1 250=1 500=1 1000=1\n"
            "1 -2: 0=-2 250=-2 500=-2 1000=-2\n"
            "1 2: 0=2 250=2 500=2 1000=2\n"
            "2 on: 0=3 250=3 500=3 1000=3\n"
            "2 off: 0=13 250=13 500=13 1000=13\n"
            "3 #0: 0=4 250=4 500=4 1000=4\n"
            "3 #1: 0=0 250=0 500=0 1000=0\n");
}

TEST(Rehearsal, StartsFromTheValuesThatAResetSets) {
  EXPECT_EQ(runs(R"j("readouts": [{"label": "v", "expr": "data.qvel[0]"}], "controls": [
      {"type": "slider", "label": "S", "bind": "data.qvel[0]", "min": 0, "max": 100, "value": 1},
      {"type": "toggle", "label": "T", "on": "data.qvel[0] += 3", "off": "data.qvel[0] -= 2",
       "value": true},
      {"type": "select", "label": "C", "value": 0,
       "options": [{"label": "a", "run": "data.qvel[0] *= 10"}]}])j"),
            "- : 0=40 250=40 500=40 1000=40\n"
            "0 0: 0=0 250=0 500=0 1000=0\n"
            "0 100: 0=100 250=100 500=100 1000=100\n"
            "1 on: 0=40 250=40 500=40 1000=40\n"
            "1 off: 0=38 250=38 500=38 1000=38\n"
            "2 #0: 0=400 250=400 500=400 1000=400\n");
}

// forward() after each control: what follows from the state is there at once.
TEST(Rehearsal, ComputesWhatFollowsFromAControl) {
  EXPECT_EQ(runs(R"j("readouts": [{"label": "z", "expr": "body('cart').xpos[2]"}], "controls": [
      {"type": "slider", "label": "S", "bind": "qpos('slide')[0]", "min": -1, "max": 1,
       "value": 0.5},
      {"type": "select", "label": "G", "value": 0,
       "options": [{"label": "0", "run": "model.opt.gravity[2] = 0"}]},
      {"type": "button", "label": "B", "run": "qpos('slide')[0] = 3"}])j"),
            "- : 0=0.5 250=0.5 500=0.5 1000=0.5\n"
            "0 -1: 0=-1 250=-1 500=-1 1000=-1\n"
            "0 1: 0=1 250=1 500=1 1000=1\n"
            "1 #0: 0=0.5 250=0.5 500=0.5 1000=0.5\n"
            "2 : 0=3 250=3 500=3 1000=3\n");
}

// The record counts steps, and a control may change how long they are.
TEST(Rehearsal, CountsItsStepsByTheTimeStepAfterTheControl) {
  EXPECT_EQ(runs(R"j("readouts": [{"label": "t", "expr": "data.time"}], "controls": [
      {"type": "button", "label": "B", "run": "model.opt.timestep = 0.3"}])j"),
            "- : 0=0 250=0.5 500=1 1000=2\n"
            "0 : 0=0 2=0.6 3=0.9 7=2.1\n");
}

TEST(Rehearsal, HasNoTimeForStepsThatAreTooSmall) {
  EXPECT_EQ(rehearsed_mistakes(R"j("controls": [
      {"type": "button", "label": "B", "run": "model.opt.timestep = 0"},
      {"type": "button", "label": "C", "run": "model.opt.timestep = 1e-6"}])j"),
            "E-lab-simulation <model.opt.timestep = 0> after \"B\": the time step is 0 s, so 2 s "
            "are more than a million steps | a larger time step\n"
            "E-lab-simulation <model.opt.timestep = 1e-6> after \"C\": the time step is 1e-06 s, "
            "so 2 s are more than a million steps | a larger time step\n");
}

TEST(Rehearsal, GoesToKeyframes) {
  const std::map<std::string, std::string> files{
      {"models/keys.xml",
       "<mujoco><worldbody><body><joint name=\"j\" axis=\"0 0 1\"/><geom size=\"1\"/></body>"
       "</worldbody><keyframe><key qpos=\"3\"/><key name=\"home\" "
       "qpos=\"1\"/></keyframe></mujoco>"}};
  const auto keyframe = [](const std::string& name) {
    return lab_text(R"j("readouts": [{"label": "q", "expr": "data.qpos[0]"}], "controls": [
      {"type": "keyframe", "label": "K", "key": ")j" +
                        name + "\"}]",
                    "keys");
  };
  const EvaluationOf found(keyframe("home"), files);
  EXPECT_EQ(found.mistakes(), "");
  const auto& result = found.result<LabResult>();
  EXPECT_EQ(result.keyframes, std::vector<int>{1});
  EXPECT_EQ(result.runs.at(1).readings.at(0).values, std::vector<double>{1});
  EXPECT_EQ(
      evaluated_mistakes(keyframe("hom"), files),
      R"(content/1-a/1.1-x.md:7:50: error: the model has no keyframe "hom" [E-keyframe-unknown]
  7 |       {"type": "keyframe", "label": "K", "key": "hom"}]}
    |                                                  ^~~
  cure: did you mean `home`?
)");
}

std::string slider_mistakes(const std::string& bind, const std::string& numbers) {
  return rehearsed_mistakes(R"("controls": [{"type": "slider", "label": "S", "bind": ")" + bind +
                            "\", " + numbers + "}]");
}

TEST(Slider, ShowsWhatItsModelHas) {
  EXPECT_EQ(
      slider_mistakes("data.qpos[2]", R"("min": 0, "max": 0.5)"),
      "E-lab-slider <data.qpos[2]> this is 1 at the start, outside the slider's range | widen "
      "\"min\" and \"max\", or give the slider a \"value\"\n");
}

TEST(Slider, ReadsWhatItHasWritten) {
  EXPECT_EQ(slider_mistakes("data.qacc[0]", R"("min": -1, "max": 1)"),
            "E-lab-slider <data.qacc[0]> set to -1, this reads 0 | bind the slider to something "
            "that keeps what is written\n");
  EXPECT_EQ(slider_mistakes("data.qacc[0]", R"("min": -1e-7, "max": 1e-7)"),
            "E-lab-slider <data.qacc[0]> set to -1e-07, this reads 0 | bind the slider to "
            "something that keeps what is written\n");
  EXPECT_EQ(slider_mistakes("model.vis.global.fovy", R"("min": 10.1, "max": 60)"), "");
  EXPECT_EQ(slider_mistakes("model.opt.iterations", R"("min": 0, "max": 100)"),
            "E-script-value <model.opt.iterations> model.opt.iterations = 0.5: not a whole number "
            "| choose \"min\", \"max\" and \"step\" so that every value fits\n");
  EXPECT_EQ(slider_mistakes("model.opt.iterations", R"("min": 0, "max": 100, "step": 5)"), "");
}

TEST(Slider, IsBoundToAPlace) {
  EXPECT_EQ(slider_mistakes("data.time + 1", R"("min": 0, "max": 2)"),
            "E-script-syntax <data.time + 1> this cannot be assigned to | name one number: "
            "data.ctrl[0], model.opt.gravity[2]\n");
  EXPECT_EQ(slider_mistakes("data.crtl[0]", R"("min": 0, "max": 2)"),
            "E-script-name <crtl> data.crtl does not exist | did you mean `data.ctrl`?\n");
  EXPECT_EQ(slider_mistakes("data.ctrl[1]", R"("min": 0, "max": 2, "value": 1)"),
            "E-script-range <data.ctrl[1]> data.ctrl[1] is out of range 0..0\n");
}

TEST(Ghost, RunsBesideTheLab) {
  EXPECT_EQ(rehearsed_mistakes(
                R"("ghost": {"label": "g", "run": "model.opt.timestep = 0.007"},
       "plots": [{"traces": [{"label": "t", "expr": "data.time"}]}],
       "controls": [{"type": "button", "label": "B", "run": "data.qvel[0] = 1"}])"),
            "");
  EXPECT_EQ(rehearsed_mistakes(R"("ghost": {"label": "g", "run": "model.opt.timestep = 0"})"),
            "E-lab-simulation <model.opt.timestep = 0> the ghost cannot keep up: its time step is "
            "too small | a larger time step\n");
  EXPECT_EQ(rehearsed_mistakes(R"("ghost": {"label": "g", "run": "data.qvle[0] = 1"})"),
            "E-script-name <qvle> data.qvle does not exist | did you mean `data.qvel`?\n");
}

// What breaks the ghost alone, and a trace that cannot be read in it.
TEST(Ghost, IsWatchedToo) {
  EXPECT_EQ(
      rehearsed_mistakes(
          R"j("ghost": {"label": "g", "run": "model.opt.gravity[2] = -1e12"},
       "controls": [{"type": "button", "label": "B", "run": ""}])j"),
      "E-lab-simulation <model.opt.gravity[2] = -1e12> in the ghost, after Play: the "
      "simulation diverged at t = 0.002 s: qacc[2] of joint `free` is infinite, not a number, "
      "or huge | a smaller time step\n");
  EXPECT_EQ(rehearsed_mistakes(
                R"j("ghost": {"label": "g", "run": "data.qvel[0] = 1"},
       "plots": [{"traces": [{"label": "t", "expr": "Math.sqrt(0.5 - data.qpos[0])"}]}])j"),
            "E-script-value <Math.sqrt(0.5 - data.qpos[0])> the value is NaN, not a finite "
            "number | look for a division by 0, or a root or a logarithm of a negative number\n");
}

}  // namespace
}  // namespace mjcourse
