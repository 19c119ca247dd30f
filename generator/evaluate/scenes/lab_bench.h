// The bench that a lab is rehearsed on.
#pragma once

#include "evaluate/context/bench.h"
#include "evaluate/scenes/lab_scripts.h"

namespace mjcourse {

class LabBench : public Bench {
 public:
  // `scripts` may be filled later; it outlives the bench.
  LabBench(const Lab& lab, const LabScripts& scripts, const Lesson& lesson, Workshop& workshop,
           Diagnostics& diagnostics)
      : Bench(lesson, workshop, diagnostics), lab_(lab), scripts_(scripts) {}

  const Lab& lab() const { return lab_; }
  // What is run of the author's `text`.
  const std::string& guarded(const LocatedText& text, ScriptKind kind) const {
    return mjcourse::guarded(scripts_, text.text, kind);
  }

 private:
  const Lab& lab_;
  const LabScripts& scripts_;
};

}  // namespace mjcourse
