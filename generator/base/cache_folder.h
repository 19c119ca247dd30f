// Where this user's caches are: ${XDG_CACHE_HOME:-~/.cache}/mjcourse. All in it can be made again.
#pragma once

#include <filesystem>
#include <optional>

namespace mjcourse {

// Made if it is not there. Nothing where the user has no home, or one that cannot be written to:
// then nothing is kept.
std::optional<std::filesystem::path> user_cache_folder();

}  // namespace mjcourse
