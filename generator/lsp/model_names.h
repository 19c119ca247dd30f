// ModelNames: what scripts can name of MuJoCo's: the fields of data and model, and the objects of
// one model.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "physics/model_cache.h"

namespace mjcourse {

class ModelNames {
 public:
  explicit ModelNames(std::filesystem::path root);

  // The fields behind "data", "model" or "model.opt", and the structures that have more of them.
  std::vector<std::string> fields(const std::string& path) const;

  // The names that the script's `function` takes ("qpos": those of joints) in a model, which is a
  // name of the course's or MJCF. None where there is no such model or function, or it is broken.
  std::vector<std::string> objects(const std::string& model, const std::string& function);

 private:
  std::filesystem::path root_;
  ModelCache models_;
  std::vector<std::string> fields_;  // "data.qpos", "model.opt.timestep"
};

}  // namespace mjcourse
