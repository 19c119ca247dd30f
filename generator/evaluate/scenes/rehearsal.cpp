#include "evaluate/scenes/rehearsal.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <sstream>
#include <utility>

namespace mjcourse {
namespace {

constexpr double kFrame = 1.0 / 60;                  // seconds between two readings, as in the page
constexpr std::array kRecorded{0.0, 0.5, 1.0, 2.0};  // seconds after which readings are kept
constexpr double kRehearsal = 2;                     // seconds

// A run that a reader can make: values that a control takes one after the other, and the last is
// the one that it is named for.
struct Deed {
  ControlValue named;
  std::vector<ControlValue> values;
};

struct DeedsOf {
  std::vector<Deed> operator()(const Lab::Button&) const { return {once({})}; }
  std::vector<Deed> operator()(const Lab::Slider& slider) const {
    return {once(slider.min), once(slider.max)};
  }
  // What is on already is not switched on.
  std::vector<Deed> operator()(const Lab::Toggle& toggle) const {
    if (toggle.value) return {{true, {}}, once(false)};
    return {once(true), {false, {true, false}}};
  }
  std::vector<Deed> operator()(const Lab::Select& select) const {
    std::vector<Deed> deeds;
    for (std::size_t i = 0; i < select.options.size(); ++i) {
      deeds.push_back(once(static_cast<int>(i)));
    }
    return deeds;
  }
  std::vector<Deed> operator()(const Lab::Keyframe&) const { return {once({})}; }

 private:
  static Deed once(const ControlValue& value) { return {value, {value}}; }
};

std::string text_of(double number) {
  std::ostringstream text;
  text.precision(10);
  text << number;
  return text.str();
}

// What is written must be read again, for the slider shows what it reads: where it starts, at both
// of its ends, and a step from one.
bool check_slider(const LabContext& context, const Lab::Slider& slider) {
  std::optional<LabRun> run = LabRun::start(context, context.lab().model);
  double found = 0;
  if (!run || !run->number(slider.bind, found)) return false;
  if (found < slider.min || found > slider.max) {
    return context.error("E-lab-slider", slider.bind.span(),
                         "this is " + text_of(found) + " at the start, outside the slider's range",
                         "widen \"min\" and \"max\", or give the slider a \"value\"");
  }
  for (const double value : {slider.min, slider.min + slider.step_size(), slider.max}) {
    if (!run->act(slider, value) || !run->number(slider.bind, found)) return false;
    if (std::abs(found - value) <= 1e-6 * std::max(slider.max - slider.min, std::abs(value))) {
      continue;
    }
    return context.error("E-lab-slider", slider.bind.span(),
                         "set to " + text_of(value) + ", this reads " + text_of(found),
                         "bind the slider to something that keeps what is written");
  }
  return true;
}

// Of the control with this index, or of none. `view`, which may be null, sees it all.
std::optional<LabRunResult> run_of(const LabContext& context, std::optional<std::size_t> control,
                                   const Deed& deed, WholeView* view) {
  std::optional<LabRun> run = LabRun::start(context, context.lab().model);
  if (!run) return std::nullopt;
  for (const ControlValue& value : deed.values) {
    if (!run->act(context.lab().controls[control.value()], value)) return std::nullopt;
  }
  if (!run->steps_in(kRehearsal)) return std::nullopt;
  LabRunResult result;
  result.control = control;
  result.value = deed.named;
  for (const double seconds : kRecorded) {
    result.readings.push_back({run->steps_in(seconds).value(), {}, {}});
  }
  const bool played = play(*run, kRehearsal, [&](int steps, const std::vector<double>& readouts) {
    if (view != nullptr) view->add(run->simulation());
    for (LabReading& reading : result.readings) {
      if (reading.steps != steps) continue;
      reading.values = readouts;
      reading.ghost = run->ghost_traces();
    }
    return true;
  });
  return played ? std::optional(result) : std::nullopt;
}

}  // namespace

bool play(LabRun& run, double seconds,
          const std::function<bool(int steps, const std::vector<double>& readouts)>& look) {
  const std::optional<int> last = run.steps_in(seconds);
  if (!last) return false;
  std::set<int> stops{*last};
  for (int frame = 0; frame * kFrame < seconds; ++frame) {
    stops.insert(*run.steps_in(frame * kFrame));
  }
  for (const double time : kRecorded) {
    if (time <= seconds) stops.insert(*run.steps_in(time));
  }
  std::vector<double> readouts;
  for (const int steps : stops) {
    if (!run.step_to(steps) || !run.read(readouts)) return false;
    if (!look(steps, readouts)) return true;
  }
  return true;
}

std::vector<LabRunResult> rehearse(const LabContext& context, WholeView* view) {
  std::vector<LabRunResult> runs;
  // What fails by itself would fail again after every control.
  std::optional<LabRunResult> alone = run_of(context, std::nullopt, {}, view);
  if (!alone) return runs;
  runs.push_back(*std::move(alone));
  const std::vector<Lab::Control>& controls = context.lab().controls;
  for (std::size_t i = 0; i < controls.size(); ++i) {
    const auto* slider = std::get_if<Lab::Slider>(&controls[i]);
    if (slider != nullptr && !check_slider(context, *slider)) continue;
    for (const Deed& deed : std::visit(DeedsOf{}, controls[i])) {
      std::optional<LabRunResult> run = run_of(context, i, deed, nullptr);
      if (!run) break;
      runs.push_back(*std::move(run));
    }
  }
  return runs;
}

}  // namespace mjcourse
