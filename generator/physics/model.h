// A compiled MuJoCo model.
//
// load_model_file(), load_model_files() and load_model_text() are the ways in. Whatever is wrong
// with the MJCF comes back as a ModelError with its line; nothing prints, waits or ends the
// process. Any thread may load while others do.
#pragma once

#include <mujoco/mujoco.h>

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "physics/mistakes/model_error.h"

namespace mjcourse {

class Model {
 public:
  // Takes ownership of `model`, which is not null.
  explicit Model(mjModel* model, std::vector<std::string> warnings = {});

  // The fields, MuJoCo's names: `model->nq`. Lessons may change them, so they are not const.
  mjModel* get() { return model_.get(); }
  const mjModel* get() const { return model_.get(); }
  mjModel* operator->() { return model_.get(); }
  const mjModel* operator->() const { return model_.get(); }

  // The name of object `id`; "" when it has none or there is no such object.
  std::string name(mjtObj type, int id) const;
  // The object of that name, -1 when there is none.
  int id(mjtObj type, const std::string& name) const;
  // All names of objects of a type in the order of their ids, for "did you mean"; without the
  // unnamed.
  std::vector<std::string> names(mjtObj type) const;

  // A number that no other model of this process has or had, to keep what was made for it.
  std::uint64_t serial() const { return serial_; }

  // What MuJoCo's compiler warned of, one line each.
  const std::vector<std::string>& warnings() const { return warnings_; }

 private:
  struct Delete {
    void operator()(mjModel* model) const { mj_deleteModel(model); }
  };
  std::unique_ptr<mjModel, Delete> model_;
  std::vector<std::string> warnings_;
  std::uint64_t serial_;
};

// The model in the MJCF or URDF file at `path`, a path on the disk. Includes, meshes and textures
// are searched relative to its folder.
tl::expected<Model, ModelError> load_model_file(const std::string& path);

// Files in memory: content by name.
using ModelFiles = std::map<std::string, std::string>;

// The model in the file `name` of `files`. Files that it names are searched among them, by the last
// part of their path whatever its case, and then on the disk.
tl::expected<Model, ModelError> load_model_files(const std::string& name, const ModelFiles& files);

// The same as load_model_file(), had that file the text `mjcf`.
tl::expected<Model, ModelError> load_model_as(const std::string& path, const std::string& mjcf);

// The model that `mjcf` describes; the error's file is "". Files that it names are searched
// relative to the working directory.
tl::expected<Model, ModelError> load_model_text(const std::string& mjcf);

}  // namespace mjcourse
