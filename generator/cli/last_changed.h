// When files of a course were changed last, as git knows it.
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace mjcourse {

// "2026-11-22", or "not committed", by path below `root`; only what git knows of `folder` in there.
// Empty where there is no git, or no repository.
std::map<std::string, std::string> last_changed(const std::filesystem::path& root,
                                                const std::string& folder);

}  // namespace mjcourse
