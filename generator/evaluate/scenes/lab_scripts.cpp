#include "evaluate/scenes/lab_scripts.h"

#include "evaluate/scenes/lab_context.h"

namespace mjcourse {
namespace {

// Goes through all scripts of a lab; every mistake is shown.
class Guarding {
 public:
  Guarding(const LabContext& context, LabScripts& scripts, std::vector<DoubtfulScript>& doubtful)
      : context_(context), scripts_(scripts), doubtful_(doubtful) {}

  bool run() {
    for (const auto& [text, kind] : scripts_of(context_.lab())) {
      if (kind != ScriptKind::assignment || guard(*text, ScriptKind::value)) {
        guard(*text, kind);
      } else {
        scripts_[lab_script_key(text->text, kind)] = text->text;  // one mistake is told once
      }
    }
    return good_;
  }

 private:
  bool guard(const LocatedText& text, ScriptKind kind) {
    WorkerContext& worker_context = context_.worker_context();
    const auto safe =
        worker_context.script_guard().guard(text.text, kind, worker_context.script_names());
    std::string& known = scripts_[lab_script_key(text.text, kind)];
    known = safe ? *safe : text.text;
    if (safe) return true;
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
