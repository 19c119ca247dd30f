// The scripts of a lab, as they are run: with their guards (script/script_guard.h).
#pragma once

#include <map>
#include <string>

namespace mjcourse {

enum class ScriptKind { script, value, assignment };

// By lab_script_key; of those alone that guards were put into.
using LabScripts = std::map<std::string, std::string>;

std::string lab_script_key(const std::string& text, ScriptKind kind);

// What is run of the author's `text`.
const std::string& guarded(const LabScripts& scripts, const std::string& text, ScriptKind kind);

}  // namespace mjcourse
