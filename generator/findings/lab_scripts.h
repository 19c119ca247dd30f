// The scripts of a lab, as they are run: with their guards (script/script_guard.h).
// Tested by tests/generator/page/blocks/lab_module_test.cpp.
#pragma once

#include <map>
#include <string>

#include "lesson/blocks/block_scripts.h"

namespace mjcourse {

// By lab_script_key.
using LabScripts = std::map<std::string, std::string>;

std::string lab_script_key(const std::string& text, ScriptKind kind);

// The form in which the author's `text` runs. Throws std::logic_error where the guard did not look
// at it, since a page must not get such a script.
const std::string& guarded(const LabScripts& scripts, const std::string& text, ScriptKind kind);

// `text` as it runs where its lab defines names, which it may declare anew. Both are guarded.
std::string behind_definitions(const std::string& definitions, const std::string& text,
                               ScriptKind kind);

// Where line `line` of that stands: in one of the two, or in neither.
struct LineBehind {
  enum class Part { none, definitions, script } part = Part::none;
  int line = 0;
};
LineBehind line_behind(const std::string& definitions, int line, ScriptKind kind);

}  // namespace mjcourse
