// Removing a folder in which somebody else's program has worked.
//
// It may have made folders that nobody may list or enter, and as many in each other as there are
// files open at most, which std::filesystem::remove_all() leaves where they are. Here each folder
// is opened to us first, and what lies in it is moved up before its turn comes.
#pragma once

#include <filesystem>
#include <string>
#include <system_error>

namespace mjcourse {

// With all that lies in it; a link is removed, and not what it leads to. Nothing works in there any
// more. The first failure is told; the rest is removed all the same. Where there is nothing of the
// name, that is no failure; and where it may not be removed itself, nothing is.
std::error_code remove_folder(const std::filesystem::path& folder);
// The same of what has the `name` in the open folder `above`.
std::error_code remove_folder(int above, const std::string& name);

}  // namespace mjcourse
