// How much lies in a folder, as the sum that no resource limit of the kernel's looks at.
#pragma once

#include <cstdint>
#include <string>

namespace mjcourse {

struct FolderSize {
  std::uint64_t bytes = 0;    // on the disk
  std::uint64_t entries = 0;  // files, links and folders
};

// Adds what is in the file or folder `path`, and stops counting behind `most` entries. What is
// removed meanwhile is not counted; no link is followed. A folder that we may not or cannot look
// into may hold anything, as may one that is a hundred levels deep: it counts as more than `most`,
// where that can be.
void add_size(const std::string& path, std::uint64_t most, FolderSize& size);

}  // namespace mjcourse
