#include "evaluate/scenes/lab.h"

#include <gtest/gtest.h>

#include "evaluate/scenes/lab_scripts.h"
#include "evaluate/scenes/lab_text.h"

namespace mjcourse {
namespace {

TEST(Lab, IsReadAtRestAndDrawn) {
  const EvaluationOf found(lab_text(R"j("overlays": {"frames": true},
    "readouts": [{"label": "z", "expr": "data.qpos[2]"}, {"label": "n", "expr": "model.nq"}],
    "plots": [{"traces": [{"label": "t", "expr": "data.time"}]}],
    "controls": [{"type": "button", "label": "Go", "run": "data.qvel[2] = 1"}])j"));
  EXPECT_EQ(found.mistakes(), "");
  const auto& result = found.result<LabResult>();
  EXPECT_EQ(result.readouts, (std::vector<double>{1, 8}));
  EXPECT_EQ(result.traces, (std::vector<std::vector<double>>{{0}}));
  EXPECT_EQ(result.overlays, (std::vector<std::string>{"frames", "tendons"}));
  EXPECT_EQ(result.poster.value().width, 712);
  EXPECT_EQ(result.poster->height, 20);
  EXPECT_EQ(result.poster->png.bytes().substr(1, 3), "PNG");
  EXPECT_EQ(result.poster->webp.bytes().substr(8, 4), "WEBP");
  EXPECT_EQ(found.tally().labs, 1);
  EXPECT_EQ(found.tally().pictures, 1);
}

// At rest means: with the values that its controls have from the start.
TEST(Lab, RestsAsItsControlsAreSet) {
  const EvaluationOf found(lab_text(R"j("readouts": [
      {"label": "x", "expr": "body('ball').xpos[0]"}],
    "controls": [{"type": "slider", "label": "X", "bind": "data.qpos[0]", "min": 0, "max": 4,
                  "value": 3}])j"));
  EXPECT_EQ(found.mistakes(), "");
  EXPECT_EQ(found.result<LabResult>().readouts, std::vector<double>{3});
}

TEST(Lab, IsSeenFromItsCameraOrWhole) {
  const EvaluationOf placed(lab_text(
      R"("camera": {"azimuth": 10, "elevation": -20, "distance": 3, "target": [0, 1, 2]})"));
  EXPECT_EQ(placed.result<LabResult>().camera.distance, 3);
  const EvaluationOf found(lab_text("\"readouts\": []"));
  const Lab::Camera& camera = found.result<LabResult>().camera;
  EXPECT_EQ(camera.azimuth, 90);
  EXPECT_EQ(camera.elevation, -45);
  EXPECT_GT(camera.distance, 1);
  EXPECT_GT(camera.target[2], 0);
}

TEST(Lab, KnowsMuJoCosOverlays) {
  EXPECT_EQ(evaluated_mistakes(lab_text(R"("toggles": ["frmes"], "overlays": {"contcts": true})")),
            R"(content/1-a/1.1-x.md:6:14: error: there is no overlay "frmes" [E-overlay-unknown]
  6 | "toggles": ["frmes"], "overlays": {"contcts": true}}
    |              ^~~~~
  cure: did you mean `frames`?
content/1-a/1.1-x.md:6:37: error: there is no overlay "contcts" [E-overlay-unknown]
  6 | "toggles": ["frmes"], "overlays": {"contcts": true}}
    |                                     ^~~~~~~
  cure: did you mean `contacts`?
)");
}

// Every readout that fails is shown, and then no button: it would fail again after each.
TEST(Lab, ShowsAllThatFailsAtRest) {
  const EvaluationOf found(lab_text(R"j("readouts": [
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
  cure: look for a division by 0, or a root or a logarithm of a negative number
content/1-a/1.1-x.md:9:49: error: data.qpos[99] is out of range 0..7 [E-script-range]
  9 |   "plots": [{"traces": [{"label": "t", "expr": "data.qpos[99]"}]}],
    |                                                 ^~~~~~~~~~~~~
)");
  EXPECT_EQ(found.tally().labs, 0);
}

TEST(Lab, HasEachOfItsButtonsPressed) {
  EXPECT_EQ(evaluated_mistakes(lab_text(R"("controls": [
  {"type": "button", "label": "One", "run": ["const a = 1;",
                                             "boom(a);"]},
  {"type": "button", "label": "Two", "run": "data.qvel[0] = 1e300"}])")),
            R"(content/1-a/1.1-x.md:8:47: error: `boom` does not exist [E-script-name]
  8 |                                              "boom(a);"]},
    |                                               ^~~~
  cure: did you mean `body`?
content/1-a/1.1-x.md:9:46: error: after "Two": the simulation diverged at t = 0 s: qvel[0] of joint `free` is infinite, not a number, or huge [E-lab-simulation]
  9 |   {"type": "button", "label": "Two", "run": "data.qvel[0] = 1e300"}]}
    |                                              ^~~~~~~~~~~~~~~~~~~~
  cure: a smaller time step, or a gentler push
)");
}

TEST(Lab, TellsWhatItTakesInAPage) {
  const auto bytes = [](const std::string& more) {
    return EvaluationOf(lab_text(more)).result<LabResult>().memory;
  };
  const std::uint64_t plain = bytes(R"("speed": 1)");
  EXPECT_GT(plain, 10'000U);
  EXPECT_GT(bytes(R"("ghost": {"label": "g", "run": "data.qvel[0] = 1"})"), 3 * plain / 2);
  EXPECT_LT(plain, 64U << 20);
}

TEST(Lab, IsReadOnTheWayToo) {
  EXPECT_EQ(
      evaluated_mistakes(
          lab_text(R"j("readouts": [{"label": "r", "expr": "Math.sqrt(1 - data.time)"}])j")),
      R"j(content/1-a/1.1-x.md:6:38: error: the value is NaN, not a finite number [E-script-value]
  6 | "readouts": [{"label": "r", "expr": "Math.sqrt(1 - data.time)"}]}
    |                                      ^~~~~~~~~~~~~~~~~~~~~~~~
  cure: look for a division by 0, or a root or a logarithm of a negative number
)j");
}

// What goes wrong a while after a button, and not without it.
TEST(Lab, IsReadAfterEachButton) {
  const std::string readout =
      R"j("readouts": [{"label": "r", "expr": "Math.sqrt(0.5 - data.qpos[0])"}])j";
  EXPECT_EQ(evaluated_mistakes(lab_text(readout)), "");
  EXPECT_EQ(
      evaluated_mistakes(lab_text(readout + R"j(,
"controls": [{"type": "button", "label": "Go", "run": "data.qvel[0] = 1"}])j")),
      R"j(content/1-a/1.1-x.md:6:38: error: the value is NaN, not a finite number [E-script-value]
  6 | "readouts": [{"label": "r", "expr": "Math.sqrt(0.5 - data.qpos[0])"}],
    |                                      ^~~~~~~~~~~~~~~~~~~~~~~~~~~~~
  cure: look for a division by 0, or a root or a logarithm of a negative number
)j");
}

TEST(Lab, StartsAfreshForEachButton) {
  const std::string button = R"j({"type": "button", "label": "B",
    "run": "if (data.time > 0) throw new Error('used'); step(10)"})j";
  EXPECT_EQ(evaluated_mistakes(lab_text("\"controls\": [" + button + ", " + button + "]")), "");
}

// What the page would refuse, the build refuses, also where nothing runs it.
TEST(Lab, HasScriptsThatStayInIt) {
  EXPECT_EQ(
      evaluated_mistakes(lab_text(R"j("controls": [
      {"type": "button", "label": "Go", "run": "step.constructor('return this')().x = 1"}],
    "readouts": [{"label": "z", "expr": "import('https://a.example/x.js')"}])j")),
      R"--(content/1-a/1.1-x.md:7:54: error: a lab's script cannot use `constructor` [E-script-foreign]
  7 |       {"type": "button", "label": "Go", "run": "step.constructor('return this')().x = 1"}],
    |                                                      ^~~~~~~~~~~
content/1-a/1.1-x.md:8:42: error: a lab's script cannot use `import` [E-script-foreign]
  8 |     "readouts": [{"label": "z", "expr": "import('https://a.example/x.js')"}]}
    |                                          ^~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~
)--");
  EXPECT_EQ(evaluated_mistakes(lab_text(R"j("controls": [
      {"type": "button", "label": "Go", "run": "if (data.time > 99) fetch('x')"}])j")),
            R"--(content/1-a/1.1-x.md:7:69: error: `fetch` does not exist [E-script-name]
  7 |       {"type": "button", "label": "Go", "run": "if (data.time > 99) fetch('x')"}]}
    |                                                                     ^~~~~
)--");
}

// Each script may declare a name of theirs anew.
TEST(Lab, HasDefinitionsForAllItsScripts) {
  const EvaluationOf found(lab_text(R"j("define": [
      "const HEIGHT = 3;",
      "function lift(by) { data.qpos[2] = HEIGHT + by; }"],
    "controls": [
      {"type": "slider", "label": "X", "bind": "data.qpos[0]", "min": 0, "max": 4, "value": 2},
      {"type": "toggle", "label": "T", "value": true, "on": "lift(1)",
       "off": "const HEIGHT = 5; lift(HEIGHT)"}],
    "readouts": [{"label": "above", "expr": "data.qpos[2] - HEIGHT"},
                 {"label": "x", "expr": "data.qpos[0]"}])j"));
  EXPECT_EQ(found.mistakes(), "");
  EXPECT_EQ(found.result<LabResult>().readouts, (std::vector<double>{1, 2}));
}

TEST(Lab, BlamesDefinitionsAndScriptsAtTheirLines) {
  EXPECT_EQ(evaluated_mistakes(lab_text(R"j("define": [
      "const z = () =>",
      "  data.qpso[2];"],
    "readouts": [{"label": "z", "expr": "z()"},
                 {"label": "y", "expr": "0 / (z - z)"},
                 {"label": "x", "expr": "data.qpos[99] + z()"}])j")),
            R"j(content/1-a/1.1-x.md:8:15: error: data.qpso does not exist [E-script-name]
  8 |       "  data.qpso[2];"],
    |               ^~~~
  cure: did you mean `data.qpos`?
content/1-a/1.1-x.md:10:42: error: the value is NaN, not a finite number [E-script-value]
  10 |                  {"label": "y", "expr": "0 / (z - z)"},
     |                                          ^~~~~~~~~~~
  cure: look for a division by 0, or a root or a logarithm of a negative number
content/1-a/1.1-x.md:11:42: error: data.qpos[99] is out of range 0..7 [E-script-range]
  11 |                  {"label": "x", "expr": "data.qpos[99] + z()"}]}
     |                                          ^~~~~~~~~~~~~
)j");
}

TEST(Lab, TellsOnceOfAMistakeInItsDefinitions) {
  const auto mistakes = [](const std::string& define) {
    return rehearsed_mistakes("\"define\": \"" + define + R"j(",
      "controls": [{"type": "button", "label": "A", "run": "f()"},
                   {"type": "button", "label": "B", "run": "f()"}])j");
  };
  EXPECT_EQ(mistakes("const f = () => step(1);"), "");
  EXPECT_EQ(mistakes("const f = () => fetch('x');"),
            "E-script-name <fetch> `fetch` does not exist | known: model, data, Math, qpos, qvel, "
            "body, geom, site, joint, sensor, ctrl, step, …\n");
  EXPECT_EQ(mistakes("const f = step.constructor;"),
            "E-script-foreign <constructor> a lab's script cannot use `constructor`\n");
  EXPECT_EQ(mistakes("let f = 1;"),
            "E-lab-define <let f = 1;> `define` declares functions and constants, and does nothing "
            "else | begin with `const` or `function`; what runs belongs into a control's script\n");
  EXPECT_EQ(
      mistakes("const data = 1;"),
      "E-lab-define <const data = 1;> `data` is a name of every script already | choose another "
      "name\n");
  EXPECT_EQ(mistakes("const f = `a"),
            "E-script-syntax <\"> the script ends too early: Unexpected EOF | look for a missing "
            "bracket, "
            "quote or operator just before this\n");
  EXPECT_EQ(mistakes("const f = data.qpos[99];"),
            "E-script-range <data.qpos[99]> data.qpos[99] is out of range 0..7\n");
  EXPECT_EQ(
      mistakes("const f = (;"),
      "E-script-syntax <;> Unexpected token ';' | look for a missing bracket, quote or operator "
      "just before this\n");
}

// JavaScriptCore's column may lie within a guard, of which the author's text has nothing.
TEST(Lab, PointsToWhatAGuardRefuses) {
  EXPECT_EQ(
      evaluated_mistakes(lab_text(R"j("controls": [
      {"type": "button", "label": "Go", "run": [
        "const b = body('ball');",
        "data.qvel[0] = data.xpos[b]"]}])j")),
      R"--(content/1-a/1.1-x.md:9:35: error: body('ball').toString does not exist [E-script-name]
  9 |         "data.qvel[0] = data.xpos[b]"]}]}
    |                                   ^
)--");
}

TEST(Lab, MarksAStrayBracketOfItsDefinitions) {
  EXPECT_EQ(
      evaluated_mistakes(lab_text(R"j("define": [
      "const a = 1;",
      "}",
      "const b = 2;"],
    "readouts": [{"label": "x", "expr": "a + b"}])j")),
      R"--(content/1-a/1.1-x.md:8:8: error: a closing bracket has no opening one [E-script-syntax]
  8 |       "}",
    |        ^
  cure: remove it, or open it
)--");
}

TEST(Lab, EndsWhereItsScriptDoesBehindDefinitions) {
  EXPECT_EQ(
      evaluated_mistakes(lab_text(R"j("define": "const a = 1;",
    "controls": [{"type": "button", "label": "Go", "run": [
        "if (a) {",
        "  step(1);"]}])j")),
      R"--(content/1-a/1.1-x.md:9:19: error: the script ends too early: Unexpected end of script [E-script-syntax]
  9 |         "  step(1);"]}]}
    |                   ^
  cure: look for a missing bracket, quote or operator just before this
)--");
  EXPECT_EQ(
      evaluated_mistakes(lab_text(R"j("define": "const a = 1;",
    "readouts": [{"label": "x", "expr": "Math.abs(data.time"}])j")),
      R"--(content/1-a/1.1-x.md:7:60: error: the script ends too early: Unexpected token ';'. Expected ')' to end a compound expression. [E-script-syntax]
  7 |     "readouts": [{"label": "x", "expr": "Math.abs(data.time"}]}
    |                                                            ^
  cure: look for a missing bracket, quote or operator just before this
)--");
}

TEST(Lab, SuggestsNamesThatItDeclares) {
  EXPECT_EQ(evaluated_mistakes(lab_text(R"j("define": "const hold = () => step(1);",
    "controls": [{"type": "button", "label": "Go", "run": "hodl()"},
                 {"type": "button", "label": "Up", "run": "const far = 2; step(fra)"}])j")),
            R"--(content/1-a/1.1-x.md:7:60: error: `hodl` does not exist [E-script-name]
  7 |     "controls": [{"type": "button", "label": "Go", "run": "hodl()"},
    |                                                            ^~~~
  cure: did you mean `hold`?
content/1-a/1.1-x.md:8:80: error: `fra` does not exist [E-script-name]
  8 |                  {"type": "button", "label": "Up", "run": "const far = 2; step(fra)"}]}
    |                                                                                ^~~
  cure: did you mean `far`?
)--");
  EXPECT_EQ(evaluated_mistakes(lab_text(R"j("define": [
      "const DEGREE = Math.PI / 180;",
      "const hold = () => step(DEGRE);"],
    "readouts": [{"label": "x", "expr": "hold()"}])j")),
            R"--(content/1-a/1.1-x.md:8:32: error: `DEGRE` does not exist [E-script-name]
  8 |       "const hold = () => step(DEGRE);"],
    |                                ^~~~~
  cure: did you mean `DEGREE`?
)--");
}

TEST(Lab, HasGuardsAroundWhatItsTextDoesNotTell) {
  EXPECT_EQ(
      evaluated_mistakes(lab_text(R"j("controls": [
      {"type": "button", "label": "Go",
       "run": "const k = 'con' + 'structor'; data.qpos[0] = step[k].length"}])j")),
      R"--(content/1-a/1.1-x.md:8:66: error: a lab's script cannot use `constructor` [E-script-foreign]
  8 |        "run": "const k = 'con' + 'structor'; data.qpos[0] = step[k].length"}]}
    |                                                                  ^
)--");
  const EvaluationOf found(lab_text(R"j("controls": [
      {"type": "slider", "label": "X", "bind": "data.qpos[0]", "min": 0, "max": 4},
      {"type": "button", "label": "Go", "run": "data.qvel[0] = data.qpos[0]"}])j"));
  EXPECT_EQ(found.mistakes(), "");
  EXPECT_EQ(
      found.result<LabResult>().scripts,
      (LabScripts{{"0data.qvel[0] = data.qpos[0]", "own$((data.qvel))/*$*/[0] = data.qpos[0]"},
                  {"1data.qpos[0]", "data.qpos[0]"},
                  {"2data.qpos[0]", "own$((data.qpos))/*$*/[0]"}}));
}

}  // namespace
}  // namespace mjcourse
