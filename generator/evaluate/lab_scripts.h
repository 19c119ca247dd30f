// The scripts of a lab, as they are run: with their guards (script/script_guard.h).
#pragma once

#include <map>
#include <string>
#include <vector>

#include "lesson/lesson.h"
#include "script/script_guard.h"

namespace mjcourse {

class LabBench;
class Workshop;

// By kind and text; of those alone that guards were put into.
using LabScripts = std::map<std::string, std::string>;

// What is run of the author's `text`.
const std::string& guarded(const LabScripts& scripts, const std::string& text, ScriptKind kind);

// One that does not parse, or names what there is not. The engine that runs it tells of that
// together with all else that goes wrong; what it does not come to, or reads otherwise, is told
// when all is well.
struct DoubtfulScript {
  const LocatedText* text;
  ScriptError error;
};

// Of the lab on `bench`. False where the page would refuse one, which is reported.
bool guard_scripts(const LabBench& bench, LabScripts& scripts,
                   std::vector<DoubtfulScript>& doubtful);

// The same of a lab whose result a worker has given: a page runs only what was guarded here. False
// where a script would have been refused.
bool guard_scripts(const Lab& lab, const Lesson& lesson, Workshop& workshop, LabScripts& scripts);

}  // namespace mjcourse
