// CommandStore: the store that a command works with, from opening it to what is said of it.
// Tested by tests/generator/cli/run_test.cpp.
#pragma once

#include <filesystem>
#include <optional>

#include "base/disk_store.h"

namespace mjcourse {

// How much a store keeps of its own accord: 2 GB.
inline constexpr std::uintmax_t kMostKept = 2'000'000'000;

class CommandStore {
 public:
  // In `folder`, or, where that is empty, in the user's cache. Where no store can be opened there
  // is none, and a note on stderr says why.
  explicit CommandStore(std::filesystem::path folder);
  // Prints the store's notes to stderr; and once a day, leaves no more than kMostKept.
  ~CommandStore();
  CommandStore(const CommandStore&) = delete;
  CommandStore& operator=(const CommandStore&) = delete;

  Store* store() { return store_ ? &*store_ : nullptr; }

 private:
  std::optional<DiskStore> store_;
};

// The folder of a store: `named`, or the user's; empty where there is none.
std::filesystem::path store_folder(const std::filesystem::path& named);

}  // namespace mjcourse
