#include "findings/lab_scripts.h"

namespace mjcourse {

std::string lab_script_key(const std::string& text, ScriptKind kind) {
  return std::to_string(static_cast<int>(kind)) + text;
}

const std::string& guarded(const LabScripts& scripts, const std::string& text, ScriptKind kind) {
  const auto found = scripts.find(lab_script_key(text, kind));
  return found == scripts.end() ? text : found->second;
}

}  // namespace mjcourse
