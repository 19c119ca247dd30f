// ResultStore: results, found again by all that they depend on.
//
// What a piece of work depends on is known in two steps. Its recipe is known before: its text,
// versions, flags. What it looks at besides, models and headers, is known once it was done. So
// under the hash of the recipe lie the lists of names that such work has looked at, newest first.
// The result lies under the hash of three things: the recipe, one of these lists, and what is now
// behind its names. A line in front of the result says all three. Both by the two verbs of
// base/store.h, so a store may lie anywhere.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "base/store.h"
#include "cache/dependency.h"
#include "cache/dependency_sets.h"
#include "cache/fingerprints.h"
#include "cache/trace.h"

namespace mjcourse {

class ResultStore {
 public:
  // Both must outlive this.
  ResultStore(Store& store, Fingerprints& fingerprints)
      : store_(store), fingerprints_(fingerprints), sets_(store, fingerprints) {}

  struct Found {
    std::string name;  // of the result
    std::string bytes;
    Dependencies traced;  // beside the recipe
    Origin origin;
  };
  struct Kept {
    std::string name;
    Dependencies traced;
  };

  // All from any thread.
  std::optional<Found> find(const Dependencies& recipe);

  // `bytes` came of `recipe`, by work that began at `begin` and looked at what is in `trace`. Gives
  // nothing, and nothing is kept, where it cannot be said what it depends on beside the recipe. It
  // is from where all is that was found in place of work.
  std::optional<Kept> keep(const Dependencies& recipe, const Trace& trace,
                           std::chrono::system_clock::time_point begin, std::string_view bytes);

  // What find() needs to come from `recipe` to a result that has looked at `traced`, is put into
  // the store, beside what others have put there.
  void put_list(const Dependencies& recipe, const Dependencies& traced);

  // What the result of that name depends on, the recipe first; empty where there is none.
  Dependencies dependencies_of(const std::string& name) const;

  // Is all behind these names as it was? It is looked at anew.
  bool still_hold(const Dependencies& traced);

  // What a result depended on, as it is now.
  Dependency now(const std::string& name);

  // As DependencySets (dependency_sets.h) has it.
  Dependencies one_by_one(const Dependencies& traced) { return sets_.one_by_one(traced); }

 private:
  using Names = std::vector<std::string>;
  std::optional<Found> find_with(const Dependencies& recipe, const Names& names);
  void add_list(const std::string& name, Names newest);
  Dependencies known(const Names& names);

  Store& store_;
  Fingerprints& fingerprints_;
  DependencySets sets_;
};

}  // namespace mjcourse
