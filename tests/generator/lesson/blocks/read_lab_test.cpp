#include "lesson/blocks/read_lab.h"

#include <gtest/gtest.h>

#include "lesson/lab_reading.h"

namespace mjcourse {
namespace {

TEST(Lab, ReadsAllThatTheSeedLessonUses) {
  const ReadingOf reading = lab_reading(R"({"title": "Zoo", "model": "joint_zoo", "alt": "Joints.",
  "dock": true, "height": 420,
  "camera": {"azimuth": 10, "elevation": -20, "distance": 3, "target": [0, 0.5, 1]},
  "toggles": ["frames", "contacts"], "overlays": {"frames": true, "contacts": false},
  "define": ["function a() {}", "const b = a;"],
  "controls": [{"type": "button", "label": "Push", "run": ["a();", "b();"]}],
  "readouts": [{"label": "w", "expr": "data.qpos[3]", "digits": 5, "unit": "m"},
               {"label": "t", "expr": "data.time"}],
  "plots": [{"ylabel": "y", "window": 2, "ymin": -1, "ymax": 1,
             "traces": [{"label": "x", "expr": "data.qpos[0]"}]}],
  "note": "Mind $q_w$."})");
  EXPECT_EQ(reading.mistakes(), "");
  const auto& found = reading.only<Lab>();
  EXPECT_EQ(found.title + " " + found.model.text, "Zoo joint_zoo");
  EXPECT_EQ(found.alt, "Joints.");
  EXPECT_TRUE(found.dock);
  EXPECT_EQ(found.height, 420);
  EXPECT_EQ(found.camera->elevation, -20);
  EXPECT_EQ(found.camera->target, (std::array{0.0, 0.5, 1.0}));
  EXPECT_EQ(found.toggles[1].text, "contacts");
  EXPECT_TRUE(found.overlays[0].on);
  EXPECT_FALSE(found.overlays[1].on);
  EXPECT_EQ(found.define.text, "function a() {}\nconst b = a;");
  EXPECT_EQ(std::get<Lab::Button>(found.controls[0]).run.text, "a();\nb();");
  EXPECT_EQ(found.readouts[0].digits, 5);
  EXPECT_EQ(found.readouts[1].digits, 3);
  EXPECT_EQ(found.readouts[1].unit, "");
  EXPECT_EQ(found.plots[0].ymax, 1);
  EXPECT_EQ(found.plots[0].traces[0].expression.text, "data.qpos[0]");
  EXPECT_EQ(reading.only<Math>().tex.text, "q_w");
}

TEST(Lab, KnowsWhereEachLineOfAScriptStands) {
  const ReadingOf reading = lab_reading(R"({"title": "T", "model": "m", "alt": "A.", "controls": [
  {"type": "button", "label": "L", "run": ["a;",
                                           "\"b\";"]}]})");
  const auto& run = std::get<Lab::Button>(reading.only<Lab>().controls[0]).run;
  EXPECT_EQ(run.text, "a;\n\"b\";");
  EXPECT_EQ(reading.place(run, 0), "6:45");
  EXPECT_EQ(reading.place(run, 3), "7:45");
  EXPECT_EQ(reading.place(run, 4), "7:47");
}

TEST(Lab, HasDefinitionsOfLimitedSize) {
  const auto mistakes = [](int buttons) {
    std::string controls;
    for (int i = 0; i < buttons; ++i) {
      controls +=
          std::string(i == 0 ? "" : ",") + R"({"type": "button", "label": "L", "run": "f"})";
    }
    return lab_reading(R"({"title": "T", "model": "m", "alt": "A.",
  "define": "const f = ')" +
                       std::string(200'000, 'x') + "';\",\n\"controls\": [" + controls + "]}")
        .mistakes();
  };
  EXPECT_EQ(mistakes(80), "");
  EXPECT_TRUE(
      mistakes(90).starts_with("content/1-a/1.1-x.md:6:14: error: `define` stands before each "
                               "script: 200013 bytes, 91 times, "
                               "are more than 16 MiB [E-lab-define]\n"))
      << mistakes(90).substr(0, 300);
}

TEST(Lab, NeedsATitleAModelAndWordsForItsPicture) {
  EXPECT_EQ(lab_reading("  {}").mistakes(),
            R"(content/1-a/1.1-x.md:5:3: error: this lab has no "title" [E-json-missing]
  5 |   {}
    |   ^
  cure: add "title": …
content/1-a/1.1-x.md:5:3: error: this lab has no "model" [E-json-missing]
  5 |   {}
    |   ^
  cure: add "model": …
content/1-a/1.1-x.md:5:3: error: this lab has no "alt" [E-json-missing]
  5 |   {}
    |   ^
  cure: add "alt": …
)");
  EXPECT_EQ(lab_reading(R"({"title": "T", "model": "", "alt": ""})").mistakes(),
            R"(content/1-a/1.1-x.md:5:25: error: "model" is empty [E-json-missing]
  5 | {"title": "T", "model": "", "alt": ""}
    |                         ^~
content/1-a/1.1-x.md:5:36: error: "alt" is empty [E-json-missing]
  5 | {"title": "T", "model": "", "alt": ""}
    |                                    ^~
)");
}

TEST(Lab, RefusesAValueOfTheWrongKind) {
  EXPECT_EQ(lab_mistakes(R"("dock": "yes", "height": [1], "note": 5)"),
            "E-json-kind <\"yes\"> \"dock\" is a string; expected true or false\n"
            "E-json-kind <[1]> \"height\" is a list; expected a number\n"
            "E-json-kind <5> \"note\" is a number; expected a string\n");
  EXPECT_EQ(lab_mistakes(R"("toggles": [1], "overlays": [], "readouts": [null])"),
            "E-json-kind <1> \"toggles\" is a number; expected a string\n"
            "E-json-kind <[]> \"overlays\" is a list; expected an object: {\"frames\": true}\n"
            "E-json-kind <null> \"readout\" is null; expected an object\n");
  EXPECT_EQ(lab_mistakes(R"("overlays": {"frames": 1}, "controls": [{"type": "button", "label": "L",
                        "run": ["a", true]}])"),
            "E-json-kind <1> \"frames\" is a number; expected true or false\n"
            "E-json-kind <true> \"run\" is true or false; expected a string (one line of the "
            "script)\n");
}

TEST(Lab, RefusesKeysThatItDoesNotKnow) {
  EXPECT_EQ(lab_mistakes(R"("modle": 1, "camera": {"azimut": 3})"),
            "E-json-key <azimut> a camera has no key \"azimut\" | did you mean `azimuth`?\n"
            "E-json-key <modle> a lab has no key \"modle\" | did you mean `model`?\n");
}

TEST(Lab, RefusesNumbersOutOfRange) {
  EXPECT_EQ(lab_mistakes(R"("camera": {"target": [1, 2]})"),
            "E-json-range <[1, 2]> \"target\" is a point: three numbers, in metres\n");
  EXPECT_EQ(lab_mistakes(R"("camera": {"target": [1, 2, "3"]})"),
            "E-json-range <[1, 2, \"3\"]> \"target\" is a point: three numbers, in metres\n");
  EXPECT_EQ(lab_mistakes(R"("height": 1e300)"),
            "E-json-range <1e300> \"height\" is a number of pixels: from 1 to 1024\n");
  EXPECT_EQ(lab_mistakes(R"("speed": 0.05)"),
            "E-json-range <0.05> \"speed\" is simulated seconds in a second: from 0.1 to 4\n");
}

TEST(Lab, RunsAtASpeedWithAGhostBesideIt) {
  const ReadingOf reading = lab_with(R"("speed": 0.25, "ghost": {"label": "coarse", "run": "a"})");
  EXPECT_EQ(reading.mistakes(), "");
  const auto& found = reading.only<Lab>();
  EXPECT_EQ(found.speed, 0.25);
  EXPECT_EQ(found.ghost.value().label, "coarse");
  EXPECT_EQ(found.ghost->run.text, "a");
  EXPECT_EQ(lab_mistakes(R"("ghost": {"label": "g"})"),
            "E-json-missing <{> this ghost has no \"run\" | add \"run\": …\n");
  EXPECT_EQ(lab_mistakes(R"("ghost": {"label": "g", "run": []})"),
            "E-json-missing <[]> \"run\" is empty\n");
}

TEST(Lab, MustBeAnObject) {
  EXPECT_EQ(lab_reading("[1, 2]").mistakes(),
            R"(content/1-a/1.1-x.md:5:1: error: "lab" is a list; expected an object [E-json-kind]
  5 | [1, 2]
    | ^~~~~~
)");
}

}  // namespace
}  // namespace mjcourse
