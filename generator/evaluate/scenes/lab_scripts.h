// Putting guards into the scripts of a lab (script/script_guard.h).
// Tested by tests/generator/evaluate/scenes/lab_test.cpp.
#pragma once

#include <vector>

#include "findings/lab_scripts.h"
#include "lesson/blocks/lesson.h"
#include "script/script_guard.h"

namespace mjcourse {

class LabContext;
class WorkerContext;

// One that does not parse, or names what there is not. The engine that runs it tells of that
// together with all else that goes wrong; what it does not come to, or reads otherwise, is told
// when all is well.
struct DoubtfulScript {
  const LocatedText* text;
  ScriptError error;
};
using DoubtfulScripts = std::vector<DoubtfulScript>;

// Guards the scripts of `context.lab()`. False where the page would refuse one, which is reported.
bool guard_scripts(const LabContext& context, LabScripts& scripts, DoubtfulScripts& doubtful);

// The same of a lab whose result a worker has given: a page runs only what was guarded here. False
// where a script would have been refused.
bool guard_scripts(const Lab& lab, const Lesson& lesson, WorkerContext& worker_context,
                   LabScripts& scripts);

}  // namespace mjcourse
