// Replace a file at once: a reader of it meanwhile, or after a crash, has the old bytes or the new.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace mjcourse {

// The bytes are written beside the file `name` in or below `folder` and renamed over it, with its
// mode; a link stays, and what it leads to is replaced. False, and nothing is done, when the file
// no longer holds `before` (nothing: when it is there). Throws std::system_error with the name, and
// RefusedPath (beneath.h) where that leads out of the folder.
bool replace_file(const std::filesystem::path& folder, const std::string& name,
                  const std::optional<std::string>& before, std::string_view after);

}  // namespace mjcourse
