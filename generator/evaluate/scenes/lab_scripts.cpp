#include "evaluate/scenes/lab_scripts.h"

#include "evaluate/scenes/lab_context.h"

namespace mjcourse {
namespace {

// Goes through all scripts of a lab; every mistake is shown.
class Guarding {
 public:
  Guarding(const LabContext& context, LabScripts& scripts, DoubtfulScripts& doubtful)
      : context_(context), scripts_(scripts), doubtful_(doubtful) {}

  // The definitions come first. One mistake is told once: not for each script that they stand
  // before, nor for both the reading and the setting of a slider's.
  bool run() {
    bool is_defined = true;
    for (const auto& [text, kind] : scripts_of(context_.lab())) {
      const bool is_told =
          !is_defined || (kind == ScriptKind::assignment && !guard(*text, ScriptKind::value));
      if (is_told) {
        keep(text->text, text->text, kind);
      } else if (!guard(*text, kind) && kind == ScriptKind::definitions) {
        is_defined = false;
      }
    }
    return good_;
  }

 private:
  bool guard(const LocatedText& text, ScriptKind kind) {
    const auto safe = context_.worker_context().script_guard().guard(text.text, kind, names_);
    const std::string& run = safe ? safe->text : text.text;
    keep(text.text, run, kind);
    if (kind == ScriptKind::definitions) {
      definitions_ = run;
      if (safe) names_.insert(names_.begin(), safe->declared.begin(), safe->declared.end());
    }
    if (safe) return true;
    if (safe.error().id == "E-script-syntax" || safe.error().id == "E-script-name") {
      doubtful_.push_back({&text, safe.error()});
    } else {
      good_ = context_.error(safe.error(), text);
    }
    return false;
  }

  void keep(const std::string& text, const std::string& safe, ScriptKind kind) {
    const bool is_behind =
        !definitions_.empty() && (kind == ScriptKind::script || kind == ScriptKind::value);
    scripts_[lab_script_key(text, kind)] =
        is_behind ? behind_definitions(definitions_, safe, kind) : safe;
  }

  const LabContext& context_;
  LabScripts& scripts_;
  DoubtfulScripts& doubtful_;
  std::vector<std::string> names_ = context_.worker_context().script_names();
  std::string definitions_;  // as they run
  bool good_ = true;
};

}  // namespace

bool guard_scripts(const LabContext& context, LabScripts& scripts, DoubtfulScripts& doubtful) {
  return Guarding(context, scripts, doubtful).run();
}

bool guard_scripts(const Lab& lab, const Lesson& lesson, WorkerContext& worker_context,
                   LabScripts& scripts) {
  scripts.clear();
  Diagnostics told;  // of what the worker has passed, and should not have
  DoubtfulScripts doubtful;
  const LabContext context(lab, scripts, lesson, worker_context, told, &doubtful);
  return guard_scripts(context, scripts, doubtful) && doubtful.empty();
}

}  // namespace mjcourse
