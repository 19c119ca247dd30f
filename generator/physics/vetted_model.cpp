#include "physics/vetted_model.h"

#include <re2/re2.h>

#include <filesystem>
#include <functional>
#include <map>
#include <mutex>
#include <new>
#include <optional>
#include <shared_mutex>
#include <utility>
#include <vector>

#include "base/content_hash.h"
#include "base/files.h"
#include "physics/data.h"
#include "physics/infinite_field.h"
#include "physics/mistakes/lost_line.h"
#include "physics/mistakes/mujoco_cures.h"
#include "physics/model_files.h"
#include "physics/mujoco_guard.h"
#include "process/attempt.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

using Loaded = tl::expected<Model, ModelError>;

constexpr std::uint64_t kMostBytes = 2ull << 30;
constexpr double kMostTrying = 20;
// MuJoCo stops earlier where the solver has converged, which some never do.
constexpr int kMostIterations = 100'000;

#if defined(__SANITIZE_ADDRESS__)
// AddressSanitizer's allocator has locks that a child inherits as they are at that moment, and then
// may wait for for ever. Other threads of ours allocate all the time, so under it nothing is tried.
constexpr bool kTries = false;
#else
constexpr bool kTries = true;
#endif

// MuJoCo holds locks while it loads. A child that is forked meanwhile would wait for them for ever.
std::shared_mutex loading;

// MuJoCo's own words where it got no memory; not an author's, who may name a body `memory`.
bool speaks_of_memory(const std::string& message) {
  static const RE2 words(
      "(?i)(?:object '[^']*': )?(?:\\w+: )?could not "
      "(?:allocate|create mjData).*");
  return RE2::FullMatch(message, words);
}

// In a child: all that takes memory and time of a model's size.
void try_out(const std::function<Loaded()>& load) {
  try {
    Loaded model = load();
    if (!model) {
      if (speaks_of_memory(model.error().message)) throw std::bad_alloc();
      return;
    }
    if (model->get()->opt.iterations > kMostIterations) return;
    const WarningLog log;
    Data data(*model);
    mj_step(model->get(), data.get());
  } catch (const MujocoError& error) {
    if (speaks_of_memory(error.what())) throw std::bad_alloc();
  }
}

std::optional<ModelError> verdict_of(Attempt attempt, const std::string& file) {
  switch (attempt) {
    case Attempt::done:
      return std::nullopt;
    case Attempt::too_much_memory:
      return ModelError{file, 0, 0, "the model needs more than 2 GiB of memory",
                        "look for a large number: njmax, nconmax, nstack, a count of a composite, "
                        "the size of a texture or a height field"};
    case Attempt::too_long:
      return ModelError{file, 0, 0, "the model made no step within 20 s",
                        "look for a large number, or a large mesh"};
    case Attempt::crashed:
      break;
  }
  return ModelError{
      file, 0, 0, "MuJoCo crashes on this model",
      "look for an index or a count that does not fit the file of a mesh, a skin or a texture"};
}

// What came of the first attempt with the same `key`, which stands for all that it read.
std::optional<ModelError> try_once(const std::string& key, const std::string& file,
                                   const std::function<Loaded()>& load) {
  static std::mutex mutex;
  static std::map<std::string, Attempt> known;
  const std::lock_guard lock(mutex);
  const auto [found, is_new] = known.try_emplace(key, Attempt::done);
  if (is_new && kTries) {
    const std::unique_lock alone(loading);
    found->second = attempt([&] { try_out(load); }, kMostBytes, kMostTrying);
  }
  return verdict_of(found->second, file);
}

// `whole` puts the model's text together, for what MuJoCo tells no line of.
Loaded load_in_peace(const std::string& file, const std::optional<ModelError>& infinite,
                     const std::function<Loaded()>& load, const std::function<WholeMjcf()>& whole) {
  const std::shared_lock lock(loading);
  Loaded model = load();
  if (!model) {
    ModelError error = model.error();
    if (error.line == 0) {
      error = with_line(std::move(error), whole(), [&](const std::string& mjcf) {
        const Loaded again = load_model_as(file, mjcf);
        return again ? ModelError{} : again.error();
      });
    }
    if (error.cure.empty()) error.cure = cure_of_model(error.message);
    return tl::unexpected(std::move(error));
  }
  if (const std::string field = find_infinite_field(*model); !field.empty()) {
    return tl::unexpected(infinite.value_or(
        ModelError{file, 0, 0, "the model's " + field + " is not a finite number", ""}));
  }
  const auto refuse = [&](const char* option) {
    return tl::unexpected(ModelError{
        file, 0, 0,
        "the solver may take more than " + std::to_string(kMostIterations) + " " + option,
        "lower it: a solver that converges needs about ten"});
  };
  const mjOption& option = model->get()->opt;
  if (option.iterations > kMostIterations) return refuse("iterations");
  if (option.noslip_iterations > kMostIterations) return refuse("noslip_iterations");
  if (option.mpr_iterations > kMostIterations) return refuse("mpr_iterations");
  return model;
}

// Of the files as they are now.
std::string key_of(const std::vector<std::string>& files) {
  std::string key;
  for (const std::string& file : files) {
    std::error_code error;
    key += file + '\n' + std::to_string(fs::file_size(file, error)) + ' ' +
           std::to_string(fs::last_write_time(file, error).time_since_epoch().count()) + '\n';
  }
  return key;
}

}  // namespace

Loaded load_vetted_file(const fs::path& root, const std::string& name) {
  install_mujoco_guard();
  NamedFiles named = look_at_model_files(root, name);
  if (named.foreign) return tl::unexpected(*std::move(named.foreign));
  const std::string path = (root / name).string();
  const auto load = [&] { return load_model_file(path); };
  if (auto wrong = try_once(key_of(named.files), path, load)) {
    return tl::unexpected(*std::move(wrong));
  }
  const auto read = [&](const std::string& file) { return read_beneath(root, file).value_or(""); };
  return load_in_peace(path, named.infinite, load,
                       [&] { return whole_mjcf(path, read(path), read); });
}

Loaded load_vetted_text(const std::string& mjcf) {
  install_mujoco_guard();
  NamedFiles named = look_at_model_text(mjcf);
  if (named.foreign) return tl::unexpected(*std::move(named.foreign));
  const auto load = [&] { return load_model_text(mjcf); };
  if (auto wrong = try_once(content_hash(mjcf), "", load)) return tl::unexpected(*std::move(wrong));
  return load_in_peace("", named.infinite, load,
                       [&] { return whole_mjcf("", mjcf, [](const auto&) { return ""; }); });
}

}  // namespace mjcourse
