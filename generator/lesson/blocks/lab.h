// ```lab simlab: an interactive simulation, as its author describes it.
//
// Scripts and expressions are kept as the author's text with its place. What the page gets of them
// is in site/browser/lab/lab-module.ts; the two have the same shape.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "lesson/syntax/located_text.h"
#include "lesson/syntax/markdown.h"

namespace mjcourse {

struct Lab {
  struct Camera {  // MuJoCo's free camera: degrees, degrees, metres, metres
    double azimuth = 90, elevation = -45, distance = 2;
    std::array<double, 3> target{};
  };
  struct Overlay {
    LocatedText name;
    bool on = false;
  };

  struct Button {
    LocatedText label, run;
  };
  struct Slider {
    LocatedText label;
    LocatedText bind;  // something that can be assigned to: data.ctrl[0]
    double min = 0, max = 1;
    std::optional<double> step;
    std::optional<double> value;  // set at every reset; without one, what the model has
    int digits = 2;
    std::string unit;

    // A two-hundredth of the way where it is not given.
    double step_size() const { return step.value_or((max - min) / 200); }
  };
  struct Toggle {
    LocatedText label, on, off;
    bool value = false;  // when true, `on` runs at every reset
  };
  struct Select {
    struct Option {
      LocatedText label, run;
    };
    LocatedText label;
    std::vector<Option> options;
    std::size_t value = 0;
    bool has_value = false;  // then that option's script runs at every reset
  };
  struct Keyframe {
    LocatedText label, key;  // the keyframe's name
  };
  using Control = std::variant<Button, Slider, Toggle, Select, Keyframe>;

  struct Readout {
    LocatedText label, expression;
    int digits = 3;
    std::string unit;
  };
  struct Plot {
    std::string ylabel;
    double window = 5;  // seconds
    std::optional<double> ymin, ymax;
    std::vector<Readout> traces;
  };

  // The reader guesses `value` as it is `seconds` after a reset on which `run` ran.
  struct Predict {
    Document question, explanation;
    LocatedText run, value;
    double seconds = 1;
    double tolerance = 0;
    int digits = 3;
    std::string unit;
  };
  // `done` turns true when the reader has done it. That this can be done is shown by a solution: a
  // script, or where the reader edits the model, another model of the course or MJCF put into this
  // one; and seconds to wait at most.
  struct Goal {
    Document text;
    LocatedText done;
    LocatedText solution_run, solution_model;
    LocatedText solution_insert, solution_before;  // the MJCF, and the text that it goes before
    double solution_seconds = 0;
    Span span;
  };
  struct Ghost {
    std::string label;
    LocatedText run;
  };
  struct Task {  // of an editable lab: a number that the reader finds for the edited model
    Document question;
    LocatedText value;
    double tolerance = 0;
    std::string unit;
  };

  std::string title;
  LocatedText model;  // a name, or MJCF where it starts with `<`
  bool dock = false;
  int height = 300;  // CSS pixels
  std::optional<Camera> camera;
  std::vector<LocatedText> toggles;
  std::vector<Overlay> overlays;
  LocatedText define;  // functions and constants that all scripts and expressions below see
  std::vector<Control> controls;
  std::vector<Readout> readouts;
  std::vector<Plot> plots;
  double speed = 1;  // simulated seconds in a second
  std::optional<Predict> predict;
  std::optional<Goal> goal;
  std::optional<Ghost> ghost;
  bool editable = false;
  std::vector<Task> tasks;
  Document note;
  std::string alt;  // what it shows at the start, in words; may be empty
  LocatedText pin;  // the name of its poster's reference picture; empty for none
  Span span;
};

}  // namespace mjcourse
