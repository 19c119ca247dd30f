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

}  // namespace mjcourse
