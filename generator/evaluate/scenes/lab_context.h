// LabContext: the context in which a lab is rehearsed.
// Tested by tests/generator/evaluate/scenes/lab_test.cpp.
#pragma once

#include "evaluate/context/block_context.h"
#include "evaluate/scenes/lab_scripts.h"

namespace mjcourse {

class LabContext : public BlockContext {
 public:
  // `scripts` and `doubtful`, which may be null, may be filled later; they outlive the context.
  LabContext(const Lab& lab, const LabScripts& scripts, const Lesson& lesson,
             WorkerContext& worker_context, Diagnostics& diagnostics,
             const DoubtfulScripts* doubtful = nullptr)
      : BlockContext(lesson, worker_context, diagnostics),
        lab_(lab),
        scripts_(scripts),
        doubtful_(doubtful) {}

  const Lab& lab() const { return lab_; }
  // What is run of the author's `text`.
  const std::string& guarded(const LocatedText& text, ScriptKind kind) const {
    return mjcourse::guarded(scripts_, text.text, kind);
  }

  using BlockContext::error;
  // Of what was run of `text`; behind the lab's definitions it counts their lines as well. Each of
  // their mistakes is reported once, however many scripts come to it.
  bool error(ScriptError error, const LocatedText& text, ScriptKind kind,
             const LocatedText* solution) const;

 private:
  // What the guard knows better than the engine, of the same mistake: the names that the lab's
  // scripts declare, and where a text does not parse.
  void sharpen(const LocatedText& text, ScriptError& error) const;

  const Lab& lab_;
  const LabScripts& scripts_;
  const DoubtfulScripts* doubtful_;
};

}  // namespace mjcourse
