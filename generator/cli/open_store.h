// OpenedStore: the store that a command works with, from opening it to what is said of it.
// Tested by tests/store/shared.mjs.
#pragma once

#include <filesystem>
#include <memory>

#include "base/disk_store.h"

namespace mjcourse {

// How much a store keeps of its own accord: 2 GB.
inline constexpr std::uintmax_t kMostKept = 2'000'000'000;

// Prints the store's notes to stderr; and once a day, leaves no more than kMostKept.
struct CloseStore {
  void operator()(DiskStore* opened) const;
};
using OpenedStore = std::unique_ptr<DiskStore, CloseStore>;

// In `folder`, or, where that is empty, in the user's cache. Null where no store can be opened; a
// note on stderr says why.
OpenedStore open_store(const std::filesystem::path& folder);

// The folder of a store: `named`, or the user's; empty where there is none.
std::filesystem::path store_folder(const std::filesystem::path& named);

}  // namespace mjcourse
