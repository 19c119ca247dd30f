#include "base/editor_files.h"

namespace mjcourse {

bool is_of_editor(std::string_view name) {
  // Vim tries with a file 4913 whether it may write into the folder.
  const bool is_emacs = name.size() > 1 && name.starts_with('#') && name.ends_with('#');
  return name.starts_with('.') || is_emacs || name.ends_with('~') || name.ends_with(".swp") ||
         name == "4913";
}

}  // namespace mjcourse
