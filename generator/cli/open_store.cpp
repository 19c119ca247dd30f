#include "cli/open_store.h"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "base/cache_folder.h"
#include "base/out_folder.h"
#include "base/utf8.h"
#include "cli/user_settings.h"
#include "cli/verify.h"
#include "report/terminal.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

// Is it a day since this was last true?
bool is_due(const fs::path& stamp) {
  std::error_code none;
  const auto last = fs::last_write_time(stamp, none);
  if (!none && fs::file_time_type::clock::now() - last < std::chrono::hours(24)) return false;
  if (!fs::is_directory(stamp.parent_path())) return false;
  fs::remove_all(stamp, none);
  OutFolder(stamp.parent_path()).write(stamp.filename(), "");
  return true;
}

// What is wrong in them is told once.
const UserSettings& settings_told_once() {
  static const UserSettings settings = [] {
    Diagnostics wrong;
    UserSettings read = user_settings(wrong);
    std::cerr << format_for_terminal(wrong, style_for(STDERR_FILENO));
    return read;
  }();
  return settings;
}

// Whom to believe of what the disk has: as the server's, where there is one, and else what the
// environment and the settings say of keys; where that is wrong, nobody.
Trust trust_with(const tl::expected<std::optional<Server>, std::string>& server) {
  if (server && *server) return (*server)->trust();
  auto keys = no_server();
  if (!keys) {
    if (server) std::cerr << "note: no result from elsewhere is used: " << keys.error() << '\n';
    return {.everybody = false};
  }
  std::ranges::copy(settings_told_once().trusted_keys, std::back_inserter(keys->trusted_keys));
  return keys->trust();
}

}  // namespace

fs::path store_folder(const fs::path& named) {
  if (!named.empty()) return fs::absolute(named);
  const std::optional<fs::path> cache = user_cache_folder();
  return cache ? *cache / "store" : fs::path();
}

tl::expected<std::optional<Server>, std::string> named_server(SharedPlace& place) {
  const UserSettings& settings = settings_told_once();
  place.read_only = place.read_only || settings.store_read_only;
  const char* const set = std::getenv("MJCOURSE_STORE_URL");
  if (place.url.empty() && set != nullptr) place.url = set;
  if (place.url.empty()) place.url = settings.store;
  if (place.url.empty() || place.url == kNoServer) return std::nullopt;
  auto server = server_at(place.url);
  if (!server) return tl::unexpected(server.error());
  std::ranges::copy(settings.trusted_keys, std::back_inserter(server->trusted_keys));
  return *std::move(server);
}

OpenedStore open_store(const fs::path& folder, SharedPlace place) {
  const auto server = named_server(place);
  const std::string no_results = server && !*server
                                     ? "note: results are not kept: "
                                     : "note: results are not kept, and no shared store is used: ";
  fs::path there = store_folder(folder);
  if (there.empty()) {
    std::cerr << no_results
              << "neither XDG_CACHE_HOME nor HOME names a folder that can be written\n";
    return {};
  }
  OpenedStore store;
  try {
    store = OpenedStore(std::make_unique<DiskStore>(std::move(there), trust_with(server)));
  } catch (const std::system_error& error) {
    std::cerr << no_results << readable(error.what()) << '\n';
    return {};
  }
  try {
    if (!server) throw std::runtime_error(server.error());
    using Sends = SharedStore::Sends;
    const Sends sends = place.read_only  ? Sends::nothing
                        : place.gets_all ? Sends::all
                                         : Sends::puts;
    if (*server) store.share(assets_folder() / "net" / "mjcourse-net", **server, sends);
  } catch (const std::exception& error) {
    std::cerr << "note: no shared store is used: " << readable(error.what()) << '\n';
  }
  return store;
}

void OpenedStore::share(const fs::path& program, const Server& server, SharedStore::Sends sends) {
  remote_ = std::make_unique<RemoteStore>(program, server, sends == SharedStore::Sends::nothing);
  shared_ = std::make_unique<SharedStore>(*disk_, *remote_, sends);
}

Store* OpenedStore::get() const {
  if (shared_) return shared_.get();
  return disk_.get();
}

void OpenedStore::wait() const {
  if (shared_) shared_->wait();
}

bool OpenedStore::came_from_server(const std::string& name) const {
  return shared_ && shared_->came_from_there(name);
}

std::optional<RemoteStore::Traffic> OpenedStore::traffic() const {
  return remote_ ? std::optional(remote_->traffic()) : std::nullopt;
}

OpenedStore::~OpenedStore() {
  if (!disk_) return;
  shared_.reset();
  const auto print = [](const std::vector<std::string>& notes) {
    for (const std::string& note : notes) std::cerr << "note: " << readable(note) << '\n';
  };
  print(disk_->notes());
  if (remote_) print(remote_->notes());
  const fs::path folder = disk_->folder();
  const bool can_be_written = disk_->can_be_written();
  disk_.reset();
  if (!can_be_written) return;
  try {
    if (is_due(folder / "pruned")) prune_store(folder, kMostKept, false);
  } catch (const std::system_error& error) {
    std::cerr << "note: the result store cannot be pruned: " << readable(error.what()) << '\n';
  }
}

}  // namespace mjcourse
