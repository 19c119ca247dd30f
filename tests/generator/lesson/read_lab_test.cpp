#include "lesson/read_lab.h"

#include <gtest/gtest.h>

#include "reading_of.h"

namespace mjcourse {
namespace {

ReadingOf lab(const std::string& json) {
  return reading_of("```lab simlab\n" + json + "\n```\n");
}

TEST(Lab, ReadsAllThatTheSeedLessonUses) {
  const ReadingOf reading =
      lab(R"({"title": "Zoo", "model": "joint_zoo", "dock": true, "height": 420,
  "camera": {"azimuth": 10, "elevation": -20, "distance": 3, "target": [0, 0.5, 1]},
  "toggles": ["frames", "contacts"], "overlays": {"frames": true, "contacts": false},
  "controls": [{"type": "button", "label": "Push", "run": ["a();", "b();"]}],
  "readouts": [{"label": "w", "expr": "data.qpos[3]", "digits": 5, "unit": "m"},
               {"label": "t", "expr": "data.time"}],
  "plots": [{"ylabel": "y", "window": 2, "ymin": -1, "ymax": 1,
             "traces": [{"label": "x", "expr": "data.qpos[0]"}]}],
  "note": "Mind $q_w$."})");
  EXPECT_EQ(reading.mistakes(), "");
  const auto& found = reading.only<Lab>();
  EXPECT_EQ(found.title + " " + found.model.text, "Zoo joint_zoo");
  EXPECT_TRUE(found.dock);
  EXPECT_EQ(found.height, 420);
  EXPECT_EQ(found.camera->elevation, -20);
  EXPECT_EQ(found.camera->target, (std::array{0.0, 0.5, 1.0}));
  EXPECT_EQ(found.toggles[1].text, "contacts");
  EXPECT_TRUE(found.overlays[0].on);
  EXPECT_FALSE(found.overlays[1].on);
  EXPECT_EQ(found.controls[0].run.text, "a();\nb();");
  EXPECT_EQ(found.readouts[0].digits, 5);
  EXPECT_EQ(found.readouts[1].digits, 3);
  EXPECT_EQ(found.readouts[1].unit, "");
  EXPECT_EQ(found.plots[0].ymax, 1);
  EXPECT_EQ(found.plots[0].traces[0].expression.text, "data.qpos[0]");
  EXPECT_EQ(reading.only<Math>().tex.text, "q_w");
}

TEST(Lab, KnowsWhereEachLineOfAScriptStands) {
  const ReadingOf reading = lab(R"({"title": "T", "model": "m", "controls": [
  {"type": "button", "label": "L", "run": ["a;",
                                           "\"b\";"]}]})");
  const LocatedText& run = reading.only<Lab>().controls[0].run;
  EXPECT_EQ(run.text, "a;\n\"b\";");
  EXPECT_EQ(reading.place(run, 0), "6:45");
  EXPECT_EQ(reading.place(run, 3), "7:45");
  EXPECT_EQ(reading.place(run, 4), "7:47");
}

TEST(Lab, NeedsATitleAndAModel) {
  EXPECT_EQ(lab("  {}").mistakes(),
            R"(content/1-a/1.1-x.md:5:3: error: this lab has no "title" [E-json-missing]
  5 |   {}
    |   ^
  cure: add "title": …
content/1-a/1.1-x.md:5:3: error: this lab has no "model" [E-json-missing]
  5 |   {}
    |   ^
  cure: add "model": …
)");
  EXPECT_EQ(lab(R"({"title": "T", "model": ""})").mistakes(),
            R"(content/1-a/1.1-x.md:5:25: error: "model" is empty [E-json-missing]
  5 | {"title": "T", "model": ""}
    |                         ^~
)");
}

// Each mistake of a lab with `members` beside its title and model: id, what it underlines, message.
std::string mistakes(const std::string& members) {
  const std::string json = R"({"title": "T", "model": "m", )" + members + "}";
  std::string text;
  for (const Diagnostic& d : lab(json).diagnostics) {
    const auto column = static_cast<std::size_t>(d.place.column - 1);
    text += d.id + " <" + d.place.excerpt.substr(column, static_cast<std::size_t>(d.place.width)) +
            "> " + d.message + (d.cure.empty() ? "" : " | " + d.cure) + "\n";
  }
  return text;
}

TEST(Lab, RefusesAValueOfTheWrongKind) {
  EXPECT_EQ(mistakes(R"("dock": "yes", "height": [1], "note": 5)"),
            "E-json-kind <\"yes\"> \"dock\" is a string; expected true or false\n"
            "E-json-kind <[1]> \"height\" is a list; expected a number\n"
            "E-json-kind <5> \"note\" is a number; expected a string\n");
  EXPECT_EQ(mistakes(R"("toggles": [1], "overlays": [], "readouts": [null])"),
            "E-json-kind <1> \"toggles\" is a number; expected a string\n"
            "E-json-kind <[]> \"overlays\" is a list; expected an object: {\"frames\": true}\n"
            "E-json-kind <null> \"readout\" is null; expected an object\n");
  EXPECT_EQ(mistakes(R"("overlays": {"frames": 1}, "controls": [{"type": "button", "label": "L",
                        "run": ["a", true]}])"),
            "E-json-kind <1> \"frames\" is a number; expected true or false\n"
            "E-json-kind <true> \"run\" is true or false; expected a string (one line of the "
            "script)\n");
}

TEST(Lab, RefusesKeysThatItDoesNotKnow) {
  EXPECT_EQ(mistakes(R"("modle": 1, "camera": {"azimut": 3})"),
            "E-json-key <azimut> a camera has no key \"azimut\" | did you mean `azimuth`?\n"
            "E-json-key <modle> a lab has no key \"modle\" | did you mean `model`?\n");
  EXPECT_EQ(mistakes(R"("plots": [{"traces": [{"label": "t", "expr": "1", "digits": 3}]}])"),
            "E-json-key <digits> a trace has no key \"digits\" | known: label, expr\n");
}

TEST(Lab, RefusesNumbersOutOfRange) {
  EXPECT_EQ(mistakes(R"("camera": {"target": [1, 2]})"),
            "E-json-range <[1, 2]> \"target\" is a point: three numbers, in metres\n");
  EXPECT_EQ(mistakes(R"("camera": {"target": [1, 2, "3"]})"),
            "E-json-range <[1, 2, \"3\"]> \"target\" is a point: three numbers, in metres\n");
  EXPECT_EQ(mistakes(R"("height": 1e300)"),
            "E-json-range <1e300> \"height\" is a number of pixels: from 1 to 10000\n");
  for (const std::string digits : {"1.5", "-1", "16"}) {
    EXPECT_EQ(mistakes(R"("readouts": [{"label": "l", "expr": "1", "digits": )" + digits + "}]"),
              "E-json-range <" + digits +
                  "> \"digits\" counts the digits after the point: a whole "
                  "number from 0 to 15\n");
  }
}

TEST(Lab, RefusesReadoutsThatReadNothing) {
  EXPECT_EQ(mistakes(R"("readouts": [{"label": "l"}], "plots": [{}])"),
            "E-json-missing <{> this readout has no \"expr\" | add \"expr\": …\n"
            "E-json-missing <{> this plot has no \"traces\" | add \"traces\": …\n");
}

TEST(Lab, SaysWhatThisVersionCannotDoYet) {
  const std::string later =
      " belongs to the lesson language, but this version of mjcourse cannot "
      "do it yet";
  EXPECT_EQ(mistakes(R"("controls": [{"type": "slider"}])"),
            "E-not-yet <slider> a \"slider\"" + later + " | use a \"button\" for now\n");
  EXPECT_EQ(mistakes(R"("controls": [{"type": "buton"}])"),
            "E-lab-control <buton> there is no control \"buton\" | did you mean `button`?\n");
  for (const std::string key : {"predict", "goal", "speed", "ghost", "editable"}) {
    EXPECT_EQ(mistakes("\"" + key + "\": 1"),
              "E-not-yet <" + key + "> \"" + key + "\"" + later + " | leave it out for now\n");
  }
}

TEST(Lab, MustBeAnObject) {
  EXPECT_EQ(lab("[1, 2]").mistakes(),
            R"(content/1-a/1.1-x.md:5:1: error: "lab" is a list; expected an object [E-json-kind]
  5 | [1, 2]
    | ^~~~~~
)");
}

}  // namespace
}  // namespace mjcourse
