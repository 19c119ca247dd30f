// ModelCache: each model is compiled once, and a caller that asks again gets a copy.
//
// Compiling draws textures and fits inertias, some 40 ms for a model with a sky; a copy takes two.
// A lab's rehearsal needs the same model a dozen times, fresh each time, as scripts may change one.
// A model is compiled again when one of its files has changed. At most eight are kept, and fewer
// where they are large. Any thread may ask.
#pragma once

#include <filesystem>
#include <functional>
#include <future>
#include <list>
#include <memory>
#include <mutex>
#include <string>

#include "physics/model.h"

namespace mjcourse {

class ModelCache {
 public:
  // As load_vetted_file() and load_vetted_text() (vetted_model.h), to the bit.
  tl::expected<Model, ModelError> file(const std::filesystem::path& root, const std::string& name);
  tl::expected<Model, ModelError> text(const std::string& mjcf);

 private:
  using Loaded = std::shared_ptr<const tl::expected<Model, ModelError>>;
  struct Kept {
    std::string name;  // with what tells a path from a text
    std::shared_future<Loaded> loaded;
    std::size_t bytes = 0;  // once it is loaded
  };

  tl::expected<Model, ModelError> get(const std::string& name,
                                      const std::function<tl::expected<Model, ModelError>()>& load);

  // `name` was loaded, and takes `bytes`: others go, those used longest ago first.
  void make_room(const std::string& name, std::size_t bytes);

  std::mutex mutex_;
  std::list<Kept> kept_;  // the last one used first
};

}  // namespace mjcourse
