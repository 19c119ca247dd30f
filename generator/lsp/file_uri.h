// File URIs: how an editor names the files that we name by their paths.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace mjcourse {

// "file:///a%20b" for "/a b".
std::string uri_of(const std::filesystem::path& path);

// Nothing where it names no file of this machine: another scheme, another host.
std::optional<std::filesystem::path> path_of(std::string_view uri);

}  // namespace mjcourse
