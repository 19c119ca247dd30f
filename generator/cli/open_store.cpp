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
#include "base/prune_store.h"
#include "base/remove_folder.h"
#include "base/utf8.h"
#include "cli/user_settings.h"
#include "cli/verify.h"
#include "report/terminal.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

using Hours = std::chrono::hours;

constexpr Hours kLong(24 * 7);

void print_note(const std::string& text) {
  std::cerr << "note: " << readable(text) << '\n';
}

// Nothing where there is no stamp, or its time is to come.
std::optional<Hours> age_of(const fs::path& stamp) {
  std::error_code none;
  const auto last = fs::last_write_time(stamp, none);
  const auto now = fs::file_time_type::clock::now();
  if (none || last > now + Hours(1)) return std::nullopt;
  return std::chrono::duration_cast<Hours>(now - last);
}

void renew(const fs::path& stamp) {
  remove_folder(stamp);
  OutFolder(stamp.parent_path()).write(stamp.filename(), "");
}

// Once a day; but while somebody uses the store, not yet.
void prune_daily(const fs::path& folder) {
  const fs::path stamp = folder / "pruned";
  const std::optional<Hours> age = age_of(stamp);
  if ((age && *age < Hours(24)) || !fs::is_directory(folder)) return;
  std::optional<Pruned> pruned;
  try {
    pruned = prune_store(folder, kMostKept, LockWait::none());
  } catch (const std::system_error&) {
    renew(stamp);  // what fails is not tried again all day
    throw;
  }
  if (pruned || !age) renew(stamp);
  if (pruned) std::ranges::for_each(pruned->notes, print_note);
  if (pruned || !age || *age < kLong) return;
  print_note("the store was not pruned for " + std::to_string(age->count() / 24) + " days, as " +
             lock_holder(open_store_lock(folder).get()) + " holds " + (folder / "lock").string());
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
    const LockWait wait{.most = DiskStore::kPatience, .tell = print_note};
    store = OpenedStore(std::make_unique<DiskStore>(std::move(there), trust_with(server), wait));
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
    print_note("no shared store is used: " + std::string(error.what()));
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
  std::ranges::for_each(disk_->notes(), print_note);
  if (remote_) std::ranges::for_each(remote_->notes(), print_note);
  const fs::path folder = disk_->folder();
  const bool can_be_written = disk_->can_be_written();
  disk_.reset();
  if (!can_be_written) return;
  try {
    prune_daily(folder);
  } catch (const std::exception& error) {
    print_note("the result store cannot be pruned: " + std::string(error.what()));
  }
}

}  // namespace mjcourse
