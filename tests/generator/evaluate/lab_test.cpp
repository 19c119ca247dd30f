#include "evaluate/lab.h"

#include <gtest/gtest.h>

#include "evaluate/evaluation_of.h"

namespace mjcourse {
namespace {

// A lab on the ball; `members` begin line 6.
std::string lab(const std::string& members) {
  return "```lab simlab\n{\"title\": \"T\", \"model\": \"ball\",\n" + members + "}\n```\n";
}

TEST(Lab, IsReadAtRestAndDrawn) {
  const EvaluationOf found(lab(R"j("overlays": {"frames": true},
    "readouts": [{"label": "z", "expr": "data.qpos[2]"}, {"label": "n", "expr": "model.nq"}],
    "plots": [{"traces": [{"label": "t", "expr": "data.time"}]}],
    "controls": [{"type": "button", "label": "Go", "run": "data.qvel[2] = 1"}])j"));
  EXPECT_EQ(found.mistakes(), "");
  const auto& result = found.result<LabResult>();
  EXPECT_EQ(result.readouts, (std::vector<double>{1, 8}));
  EXPECT_EQ(result.traces, (std::vector<std::vector<double>>{{0}}));
  EXPECT_EQ(result.poster.value().width, 960);
  EXPECT_EQ(result.poster->png.substr(1, 3), "PNG");
  EXPECT_EQ(result.poster->webp.substr(8, 4), "WEBP");
  EXPECT_EQ(found.tally().labs, 1);
  EXPECT_EQ(found.tally().pictures, 1);
}

TEST(Lab, KnowsMuJoCosOverlays) {
  EXPECT_EQ(evaluated_mistakes(lab(R"("toggles": ["frmes"], "overlays": {"contcts": true})")),
            R"(content/1-a/1.1-x.md:6:14: error: there is no overlay "frmes" [E-lab-overlay]
  6 | "toggles": ["frmes"], "overlays": {"contcts": true}}
    |              ^~~~~
  cure: did you mean `frames`?
content/1-a/1.1-x.md:6:37: error: there is no overlay "contcts" [E-lab-overlay]
  6 | "toggles": ["frmes"], "overlays": {"contcts": true}}
    |                                     ^~~~~~~
  cure: did you mean `contacts`?
)");
}

// Every readout that fails is shown, and then no button: it would fail again after each.
TEST(Lab, ShowsAllThatFailsAtRest) {
  const EvaluationOf found(lab(R"j("readouts": [
  {"label": "z", "expr": "data.qpso[2]"},
  {"label": "y", "expr": "0/0"}],
  "plots": [{"traces": [{"label": "t", "expr": "data.qpos[99]"}]}],
  "controls": [{"type": "button", "label": "Go", "run": "boom()"}])j"));
  EXPECT_EQ(found.mistakes(),
            R"(content/1-a/1.1-x.md:7:32: error: data.qpso does not exist [E-script-name]
  7 |   {"label": "z", "expr": "data.qpso[2]"},
    |                                ^~~~
  cure: did you mean `data.qpos`?
content/1-a/1.1-x.md:8:27: error: the value is NaN, not a finite number [E-script-value]
  8 |   {"label": "y", "expr": "0/0"}],
    |                           ^~~
content/1-a/1.1-x.md:9:49: error: data.qpos[99] is out of range 0..7 [E-script-range]
  9 |   "plots": [{"traces": [{"label": "t", "expr": "data.qpos[99]"}]}],
    |                                                 ^~~~~~~~~~~~~
)");
  EXPECT_EQ(found.tally().labs, 0);
}

TEST(Lab, HasEachOfItsButtonsPressed) {
  EXPECT_EQ(evaluated_mistakes(lab(R"("controls": [
  {"type": "button", "label": "One", "run": ["const a = 1;",
                                             "boom(a);"]},
  {"type": "button", "label": "Two", "run": "data.qvel[0] = 1e300"}])")),
            R"(content/1-a/1.1-x.md:8:47: error: `boom` does not exist [E-script-name]
  8 |                                              "boom(a);"]},
    |                                               ^~~~
  cure: did you mean `body`?
content/1-a/1.1-x.md:9:46: error: after "Two": the simulation diverged at t = 0.002 s: qvel[0] of joint `free` is infinite, not a number, or huge [E-lab-simulation]
  9 |   {"type": "button", "label": "Two", "run": "data.qvel[0] = 1e300"}]}
    |                                              ^~~~~~~~~~~~~~~~~~~~
  cure: a smaller time step, or a gentler push
)");
}

TEST(Lab, IsReadOnTheWayToo) {
  EXPECT_EQ(
      evaluated_mistakes(
          lab(R"j("readouts": [{"label": "r", "expr": "Math.sqrt(1 - data.time)"}])j")),
      R"j(content/1-a/1.1-x.md:6:38: error: the value is NaN, not a finite number [E-script-value]
  6 | "readouts": [{"label": "r", "expr": "Math.sqrt(1 - data.time)"}]}
    |                                      ^~~~~~~~~~~~~~~~~~~~~~~~
)j");
}

// What goes wrong a while after a button, and not without it.
TEST(Lab, IsReadAfterEachButton) {
  const std::string readout =
      R"j("readouts": [{"label": "r", "expr": "Math.sqrt(0.5 - data.qpos[0])"}])j";
  EXPECT_EQ(evaluated_mistakes(lab(readout)), "");
  EXPECT_EQ(
      evaluated_mistakes(lab(readout + R"j(,
"controls": [{"type": "button", "label": "Go", "run": "data.qvel[0] = 1"}])j")),
      R"j(content/1-a/1.1-x.md:6:38: error: the value is NaN, not a finite number [E-script-value]
  6 | "readouts": [{"label": "r", "expr": "Math.sqrt(0.5 - data.qpos[0])"}],
    |                                      ^~~~~~~~~~~~~~~~~~~~~~~~~~~~~
)j");
}

TEST(Lab, StartsAfreshForEachButton) {
  const std::string button = R"j({"type": "button", "label": "B",
    "run": "if (data.time > 0) throw new Error('used'); step(10)"})j";
  EXPECT_EQ(evaluated_mistakes(lab("\"controls\": [" + button + ", " + button + "]")), "");
}

}  // namespace
}  // namespace mjcourse
