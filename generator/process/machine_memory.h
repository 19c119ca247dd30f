// How much memory there is for us: the machine's, or what a control group leaves of it, as that of
// a container does.
#pragma once

#include <cstdint>
#include <filesystem>

namespace mjcourse {

// Bytes; the largest number where nothing tells. `root` has proc/ and sys/.
std::uint64_t machine_memory(const std::filesystem::path& root = "/");

}  // namespace mjcourse
