#include "findings/lab_scripts.h"

#include <stdexcept>

namespace mjcourse {

std::string lab_script_key(const std::string& text, ScriptKind kind) {
  return std::to_string(static_cast<int>(kind)) + text;
}

const std::string& guarded(const LabScripts& scripts, const std::string& text, ScriptKind kind) {
  if (text.empty()) return text;
  const auto found = scripts.find(lab_script_key(text, kind));
  if (found == scripts.end()) throw std::logic_error("the script `" + text + "` has no guards");
  return found->second;
}

}  // namespace mjcourse
