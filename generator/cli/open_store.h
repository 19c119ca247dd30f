// OpenedStore: the store that a command works with, from opening it to what is said of it.
// Tested by tests/store/shared.mjs.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <utility>

#include "base/disk_store.h"
#include "remote/remote_store.h"
#include "remote/shared_store.h"

namespace mjcourse {

// How much a store keeps of its own accord: 2 GB.
inline constexpr std::uintmax_t kMostKept = 2'000'000'000;

// An address that says: no server, whatever the environment says.
inline constexpr const char* kNoServer = "none";

// The server that a user named on the command line.
struct SharedPlace {
  std::string url;  // empty for what MJCOURSE_STORE_URL or the user's settings say
  bool read_only = false;
  bool gets_all = false;  // also what the disk had before
};

class OpenedStore {
 public:
  OpenedStore() = default;
  explicit OpenedStore(std::unique_ptr<DiskStore> disk) : disk_(std::move(disk)) {}
  OpenedStore(OpenedStore&&) = default;
  OpenedStore& operator=(OpenedStore&&) = default;
  // Waits until the shared store has all; prints the stores' notes to stderr; and once a day,
  // leaves no more than kMostKept on the disk.
  ~OpenedStore();

  // With a server before which this store is from now on. Throws std::system_error.
  void share(const std::filesystem::path& program, const Server& server, SharedStore::Sends sends);

  // Null where no store could be opened.
  Store* get() const;
  // Was this entry asked of the server?
  bool came_from_server(const std::string& name) const;
  // Null where none is shared.
  const RemoteStore* remote() const { return remote_.get(); }
  // Until the shared store has all that was put.
  void wait() const;
  // Of the shared store; nothing where there is none.
  std::optional<RemoteStore::Traffic> traffic() const;

 private:
  std::unique_ptr<DiskStore> disk_;
  std::unique_ptr<RemoteStore> remote_;
  std::unique_ptr<SharedStore> shared_;
};

// The server that `place`, the environment or the user's settings name, the first of them; nothing
// where none does. Then `place` says all of it. What is wrong with the environment's.
tl::expected<std::optional<Server>, std::string> named_server(SharedPlace& place);

// In `folder`, or, where that is empty, in the user's cache. Without a store where none can be
// opened; a note on stderr says why.
OpenedStore open_store(const std::filesystem::path& folder, SharedPlace place);

// The folder of a store: `named`, or the user's; empty where there is none.
std::filesystem::path store_folder(const std::filesystem::path& named);

}  // namespace mjcourse
