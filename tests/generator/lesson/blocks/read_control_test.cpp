#include "lesson/blocks/read_control.h"

#include <gtest/gtest.h>

#include "lesson/lab_reading.h"

namespace mjcourse {
namespace {

std::string control_mistakes(const std::string& control) {
  return lab_mistakes("\"controls\": [" + control + "]");
}

// The only control of a lab, which is a T.
template <typename T>
T control(const ReadingOf& reading) {
  EXPECT_EQ(reading.mistakes(), "");
  return std::get<T>(reading.only<Lab>().controls.at(0));
}

ReadingOf lab_of(const std::string& control) {
  return lab_with("\"controls\": [" + control + "]");
}

TEST(Control, MayBeASlider) {
  const auto least = control<Lab::Slider>(
      lab_of(R"({"type": "slider", "label": "L", "bind": "data.ctrl[0]", "min": -1, "max": 2})"));
  EXPECT_EQ(least.bind.text, "data.ctrl[0]");
  EXPECT_EQ(least.min, -1);
  EXPECT_EQ(least.max, 2);
  EXPECT_FALSE(least.step);
  EXPECT_FALSE(least.value);
  EXPECT_EQ(least.digits, 2);
  const auto most = control<Lab::Slider>(
      lab_of(R"({"type": "slider", "label": "L", "bind": "b", "min": 0, "max": 0.3, "step": 0.1,
                 "value": 0.2, "digits": 1, "unit": "N"})"));
  EXPECT_EQ(most.step, 0.1);
  EXPECT_EQ(most.value, 0.2);
  EXPECT_EQ(most.digits, 1);
  EXPECT_EQ(most.unit, "N");
}

TEST(Control, MayBeAToggle) {
  const auto toggle = control<Lab::Toggle>(
      lab_of(R"({"type": "toggle", "label": "L", "on": "a", "off": ["b"], "value": true})"));
  EXPECT_EQ(toggle.on.text + " " + toggle.off.text, "a b");
  EXPECT_TRUE(toggle.value);
  EXPECT_EQ(control_mistakes(R"({"type": "toggle", "label": "L", "on": ""})"),
            "E-json-missing <\"\"> \"on\" is empty\n"
            "E-json-missing <{> this toggle has no \"off\" | add \"off\": …\n");
}

TEST(Control, MayBeASelect) {
  const std::string options = R"("options": [{"label": "A", "run": "a"},
                                             {"label": "B", "run": ""}])";
  const auto none =
      control<Lab::Select>(lab_of(R"({"type": "select", "label": "L", )" + options + "}"));
  EXPECT_EQ(none.options[1].label.text, "B");
  EXPECT_FALSE(none.has_value);
  const auto second = control<Lab::Select>(
      lab_of(R"({"type": "select", "label": "L", "value": 1, )" + options + "}"));
  EXPECT_TRUE(second.has_value);
  EXPECT_EQ(second.value, 1U);
  EXPECT_EQ(
      control_mistakes(R"({"type": "select", "label": "L", "value": 2,
      "options": [{"label": "A"}, {"run": "b"
  }]
  })"),
      "E-json-missing <{> this option does nothing: it has no \"run\" | add \"run\": a script\n"
      "E-json-missing <{> this option has no \"label\" | add \"label\": …\n"
      "E-json-range <2> \"value\" is the index of an option, counted from 0\n");
  EXPECT_EQ(control_mistakes(R"({"type": "select", "label": "L", "options": []})"),
            "E-json-missing <[]> \"options\" is empty | add options: {\"label\": …, \"run\": …}\n");
}

TEST(Control, MayBeAKeyframe) {
  const auto keyframe =
      control<Lab::Keyframe>(lab_of(R"({"type": "keyframe", "label": "L", "key": "home"})"));
  EXPECT_EQ(keyframe.key.text, "home");
}

TEST(Control, IsNamedByItsMistakes) {
  EXPECT_EQ(control_mistakes(R"({"type": "slidr", "label": "L"})"),
            "E-lab-control <slidr> there is no control \"slidr\" | did you mean `slider`?\n");
  EXPECT_EQ(control_mistakes(R"({"type": "keyframe", "label": "L"})"),
            "E-json-missing <{> this keyframe has no \"key\" | add \"key\": …\n");
  EXPECT_EQ(control_mistakes(R"({"type": "slider", "label": "L", "binds": "b"})"),
            "E-json-missing <{> this slider has no \"bind\" | add \"bind\": …\n"
            "E-json-missing <{> this slider has no \"min\" | add \"min\": …\n"
            "E-json-missing <{> this slider has no \"max\" | add \"max\": …\n"
            "E-json-key <binds> a slider has no key \"binds\" | did you mean `bind`?\n");
  EXPECT_EQ(control_mistakes("3"), "E-json-kind <3> \"control\" is a number; expected an object\n");
}

TEST(Control, ThatCouldDoNothingIsLeftOut) {
  const ReadingOf reading = lab_of(R"({"type": "slider", "label": "L", "bind": "b", "min": 1}, 3,
      {"type": "keyframe", "label": "L"}, {"type": "select", "label": "L"}, {"type": "x"})");
  EXPECT_EQ(reading.only<Lab>().controls.size(), 0U);
}

// Of a slider with these members beside its bind.
std::string slider_mistakes(const std::string& members) {
  return control_mistakes(R"({"type": "slider", "label": "L", "bind": "b", )" + members + "}");
}

TEST(Slider, HasNumbersThatGoTogether) {
  EXPECT_EQ(slider_mistakes(R"("min": 1, "max": 1)"),
            "E-lab-slider <1> a slider goes up from \"min\" to \"max\" | make \"max\" the larger "
            "one\n");
  for (const std::string step : {"0.3", "2"}) {
    EXPECT_EQ(slider_mistakes(R"("min": 0, "max": 1, "step": )" + step),
              "E-lab-slider <" + step +
                  "> the steps do not reach from \"min\" to \"max\" | make \"max\" - \"min\" a "
                  "whole number of steps\n");
  }
  EXPECT_EQ(slider_mistakes(R"("min": 0, "max": 1, "step": 0)"),
            "E-json-range <0> \"step\" is how far the slider goes at a time: more than 0\n");
  EXPECT_EQ(slider_mistakes(R"("min": 0, "max": 1, "value": 2)"),
            "E-lab-slider <2> the slider starts outside of its \"min\" and \"max\" | choose a "
            "value between them\n");
  EXPECT_EQ(slider_mistakes(R"("min": 0, "max": 1, "step": 0.5, "value": 0.7)"),
            "E-lab-slider <0.7> the slider starts between two of its steps | make \"value\" - "
            "\"min\" a whole number of steps\n");
  EXPECT_EQ(slider_mistakes(R"("min": "0", "max": 1, "step": "x")"),
            "E-json-kind <\"0\"> \"min\" is a string; expected a number\n"
            "E-json-kind <\"x\"> \"step\" is a string; expected a number\n");
}

}  // namespace
}  // namespace mjcourse
