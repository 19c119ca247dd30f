// What editors write beside a file for themselves: swap files, backups, locks.
#pragma once

#include <string_view>

namespace mjcourse {

// Is a file or a folder of this name an editor's own, and none of its author's? So is all that is
// hidden.
bool is_of_editor(std::string_view name);

}  // namespace mjcourse
