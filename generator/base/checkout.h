// The checkout that a folder lies in: all that a change from somebody else can bring links into,
// and more than the course where that is a folder of a repository.
#pragma once

#include <filesystem>
#include <optional>

namespace mjcourse {

// Absolute and without links; the outer one where one lies in another, since a submodule is what
// the outer one says. A home folder that is a checkout itself is its user's. Nothing for a folder
// that is in none.
std::optional<std::filesystem::path> checkout_of(const std::filesystem::path& folder);

}  // namespace mjcourse
