#include "physics/model_cache.h"

#include <sys/stat.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <numeric>
#include <optional>
#include <sstream>
#include <vector>

#include "physics/model_files.h"
#include "physics/vetted_model.h"

namespace mjcourse {
namespace {

constexpr std::size_t kMostModels = 8;         // a sky alone takes 5 MB
constexpr std::size_t kMostBytes = 128 << 20;  // of all together, but for the one used last

// The same to the bit, but for its serial number.
Model copy_of(const Model& model) {
  return Model(mj_copyModel(nullptr, model.get()), model.warnings());
}

// All that changes with the files; nothing where one was changed just now. The kernel's clock for
// files goes in ticks of up to 10 ms, and a change within the same tick would not show.
std::optional<std::string> status_of(const std::vector<std::string>& files) {
  constexpr auto tick = std::chrono::milliseconds(20);
  std::ostringstream text;
  for (const std::string& file : files) {
    struct stat status {};
    if (stat(file.c_str(), &status) != 0) return std::nullopt;
    const std::chrono::system_clock::time_point changed(
        std::chrono::seconds(status.st_ctim.tv_sec) +
        std::chrono::duration_cast<std::chrono::system_clock::duration>(
            std::chrono::nanoseconds(status.st_ctim.tv_nsec)));
    if (std::chrono::system_clock::now() - changed < tick) return std::nullopt;
    text << file << ' ' << status.st_ino << ' ' << status.st_size << ' '
         << changed.time_since_epoch().count() << '\n';
  }
  return text.str();
}

}  // namespace

tl::expected<Model, ModelError> ModelCache::file(const std::filesystem::path& root,
                                                 const std::string& name) {
  const auto load = [&] { return load_vetted_file(root, name); };
  const NamedFiles named = look_at_model_files(root, name);
  // Of one that is refused, another run may find another.
  const std::optional<std::string> status = named.foreign ? std::nullopt : status_of(named.files);
  return status ? get("file " + (root / name).string() + "\n" + *status, load) : load();
}

tl::expected<Model, ModelError> ModelCache::text(const std::string& mjcf) {
  return get("text " + mjcf, [&] { return load_vetted_text(mjcf); });
}

tl::expected<Model, ModelError> ModelCache::get(
    const std::string& name, const std::function<tl::expected<Model, ModelError>()>& load) {
  std::promise<Loaded> promise;
  std::shared_future<Loaded> loaded;
  bool first = false;
  {
    const std::lock_guard lock(mutex_);
    const auto found = std::find_if(kept_.begin(), kept_.end(),
                                    [&](const Kept& kept) { return kept.name == name; });
    first = found == kept_.end();
    if (first) {
      kept_.push_front({name, promise.get_future().share()});
      if (kept_.size() > kMostModels) kept_.pop_back();
    } else {
      kept_.splice(kept_.begin(), kept_, found);
    }
    loaded = kept_.front().loaded;
  }
  if (first) {
    try {
      promise.set_value(std::make_shared<const tl::expected<Model, ModelError>>(load()));
    } catch (...) {
      promise.set_exception(std::current_exception());
    }
  }
  const tl::expected<Model, ModelError>& model = *loaded.get();
  if (first && model) make_room(name, static_cast<std::size_t>((*model)->nbuffer));
  if (!model) return tl::unexpected(model.error());
  return copy_of(*model);
}

void ModelCache::make_room(const std::string& name, std::size_t bytes) {
  const std::lock_guard lock(mutex_);
  for (Kept& kept : kept_) {
    if (kept.name == name) kept.bytes = bytes;
  }
  const auto all = [&] {
    return std::accumulate(kept_.begin(), kept_.end(), std::size_t{0},
                           [](std::size_t sum, const Kept& kept) { return sum + kept.bytes; });
  };
  while (kept_.size() > 1 && all() > kMostBytes) kept_.pop_back();
}

}  // namespace mjcourse
