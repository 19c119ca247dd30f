#include "cli/open_store.h"

#include <chrono>
#include <fstream>
#include <iostream>
#include <system_error>
#include <utility>

#include "base/cache_folder.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

// Is it a day since this was last true?
bool is_due(const fs::path& stamp) {
  std::error_code none;
  const auto last = fs::last_write_time(stamp, none);
  if (!none && fs::file_time_type::clock::now() - last < std::chrono::hours(24)) return false;
  fs::remove(stamp, none);  // a link may lead to what is somebody's
  std::ofstream(stamp) << "";
  return true;
}

}  // namespace

fs::path store_folder(const fs::path& named) {
  if (!named.empty()) return fs::absolute(named);
  const std::optional<fs::path> cache = user_cache_folder();
  return cache ? *cache / "store" : fs::path();
}

OpenedStore open_store(const fs::path& folder) {
  fs::path place = store_folder(folder);
  if (place.empty()) {
    std::cerr << "note: results are not kept: neither XDG_CACHE_HOME nor HOME names a folder that "
                 "can be written\n";
    return nullptr;
  }
  try {
    return OpenedStore(std::make_unique<DiskStore>(std::move(place)).release());
  } catch (const std::system_error& error) {
    std::cerr << "note: results are not kept: " << error.what() << '\n';
    return nullptr;
  }
}

void CloseStore::operator()(DiskStore* opened) const {
  std::unique_ptr<DiskStore> store(opened);
  for (const std::string& note : store->notes()) std::cerr << "note: " << note << '\n';
  const fs::path folder = store->folder();
  const bool can_be_written = store->can_be_written();
  store.reset();
  if (!can_be_written) return;
  try {
    if (is_due(folder / "pruned")) prune_store(folder, kMostKept, false);
  } catch (const std::system_error& error) {
    std::cerr << "note: the result store cannot be pruned: " << error.what() << '\n';
  }
}

}  // namespace mjcourse
