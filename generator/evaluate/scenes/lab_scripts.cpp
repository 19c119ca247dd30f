#include "evaluate/scenes/lab_scripts.h"

#include "evaluate/scenes/lab_context.h"

namespace mjcourse {
namespace {

// Goes through all of a lab; every mistake is shown.
class Guarding {
 public:
  Guarding(const LabContext& context, LabScripts& scripts, std::vector<DoubtfulScript>& doubtful)
      : context_(context), scripts_(scripts), doubtful_(doubtful) {}

  bool run() {
    const Lab& lab = context_.lab();
    for (const Lab::Control& control : lab.controls) std::visit(*this, control);
    for (const Lab::Readout& readout : lab.readouts) add(readout.expression, ScriptKind::value);
    for (const Lab::Plot& plot : lab.plots) {
      for (const Lab::Readout& trace : plot.traces) add(trace.expression, ScriptKind::value);
    }
    if (lab.predict) {
      add(lab.predict->run, ScriptKind::script);
      add(lab.predict->value, ScriptKind::value);
    }
    if (lab.goal) {
      add(lab.goal->done, ScriptKind::value);
      add(lab.goal->solution_run, ScriptKind::script);
    }
    if (lab.ghost) add(lab.ghost->run, ScriptKind::script);
    for (const Lab::Task& task : lab.tasks) add(task.value, ScriptKind::value);
    return good_;
  }

  void operator()(const Lab::Button& button) { add(button.run, ScriptKind::script); }
  void operator()(const Lab::Slider& slider) {
    if (add(slider.bind, ScriptKind::value)) add(slider.bind, ScriptKind::assignment);
  }
  void operator()(const Lab::Toggle& toggle) {
    add(toggle.on, ScriptKind::script);
    add(toggle.off, ScriptKind::script);
  }
  void operator()(const Lab::Select& select) {
    for (const Lab::Select::Option& option : select.options) add(option.run, ScriptKind::script);
  }
  void operator()(const Lab::Keyframe&) {}

 private:
  bool add(const LocatedText& text, ScriptKind kind) {
    if (text.text.empty()) return true;
    WorkerContext& worker_context = context_.worker();
    const auto safe =
        worker_context.script_guard().guard(text.text, kind, worker_context.script_names());
    if (safe) {
      if (*safe != text.text) scripts_[lab_script_key(text.text, kind)] = *safe;
      return true;
    }
    if (safe.error().id == "E-script-syntax" || safe.error().id == "E-script-name") {
      doubtful_.push_back({&text, safe.error()});
    } else {
      good_ = context_.error(safe.error(), text);
    }
    return false;
  }

  const LabContext& context_;
  LabScripts& scripts_;
  std::vector<DoubtfulScript>& doubtful_;
  bool good_ = true;
};

}  // namespace

bool guard_scripts(const LabContext& context, LabScripts& scripts,
                   std::vector<DoubtfulScript>& doubtful) {
  return Guarding(context, scripts, doubtful).run();
}

bool guard_scripts(const Lab& lab, const Lesson& lesson, WorkerContext& worker_context,
                   LabScripts& scripts) {
  scripts.clear();
  Diagnostics told;  // of what the worker has passed, and should not have
  std::vector<DoubtfulScript> doubtful;
  const LabContext context(lab, scripts, lesson, worker_context, told);
  return guard_scripts(context, scripts, doubtful) && doubtful.empty();
}

}  // namespace mjcourse
