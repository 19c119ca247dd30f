// Replace a file at once: whoever reads it meanwhile, or after a crash, has the old bytes or the
// new.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace mjcourse {

// The bytes are written beside the file and renamed over it, with its mode; a link stays, and what
// it leads to is replaced. False, and nothing is done, when the file no longer holds `before`
// (nothing: when it is there). Throws std::system_error with the path.
bool replace_file(const std::filesystem::path& path, const std::optional<std::string>& before,
                  std::string_view after);

}  // namespace mjcourse
