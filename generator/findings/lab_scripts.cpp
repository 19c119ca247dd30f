#include "findings/lab_scripts.h"

#include <algorithm>
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

// A value can only be an expression, so a function gives it. Its `return` is on a line of its own,
// and so are all brackets here: each line of the author's is one of his alone.
std::string behind_definitions(const std::string& definitions, const std::string& text,
                               ScriptKind kind) {
  if (kind == ScriptKind::value) {
    return "(() => {\n" + definitions + "\nreturn (\n" + text + "\n);\n})()";
  }
  return definitions + "\n{\n" + text + "\n}";
}

LineBehind line_behind(const std::string& definitions, int line, ScriptKind kind) {
  const int before = kind == ScriptKind::value ? 1 : 0;
  const int count = 1 + static_cast<int>(std::ranges::count(definitions, '\n'));
  if (line > before + count + 1) return {LineBehind::Part::script, line - before - count - 1};
  if (line > before && line <= before + count) {
    return {LineBehind::Part::definitions, line - before};
  }
  return {};
}

}  // namespace mjcourse
