// Forgetting what a store (disk_store.h) has not used for longest.
//
// Others may write into a shared store, and put anything there. So the walk goes no deeper than a
// store writes, by open folders and through no link, and what it cannot list or remove does not
// keep the rest from being removed.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/lock_wait.h"

namespace mjcourse {

struct Pruned {
  struct Count {
    std::uintmax_t results = 0, prepared = 0, bytes = 0;
  };
  Count removed, left;
  // Sentences for the user: of what is no store's, of what lay in an entry's place, of what cannot
  // be removed.
  std::vector<std::string> notes;
};

// Remove the entries that were not used for longest until the store in `folder` holds at most
// `keep` bytes, and what killed processes left. Throws std::system_error where it is none, or
// cannot be locked. Waits for runs that use the store; where that ends, nothing is done, and
// nothing given.
std::optional<Pruned> prune_store(const std::filesystem::path& folder, std::uintmax_t keep,
                                  const LockWait& wait = {});

}  // namespace mjcourse
