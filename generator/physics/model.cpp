#include "physics/model.h"

#include <array>
#include <atomic>
#include <cstring>

#include "physics/mujoco_guard.h"
#include "physics/object_count.h"

namespace mjcourse {
namespace {

// What mj_loadXML makes of `path`, which is in `vfs` or, without one, on the disk: the model and
// its warnings, or MuJoCo's answer.
tl::expected<Model, std::string> load(const std::string& path, const mjVFS* vfs) {
  const WarningLog log;
  std::array<char, 1000> answer{};
  try {
    mjModel* model = mj_loadXML(path.c_str(), vfs, answer.data(), static_cast<int>(answer.size()));
    if (model == nullptr) return tl::unexpected(std::string(answer.data()));
    std::vector<std::string> warnings = log.warnings();
    if (answer[0] != '\0') warnings.emplace_back(answer.data());
    return Model(model, std::move(warnings));
  } catch (const MujocoError& error) {
    return tl::unexpected(std::string(error.what()));
  }
}

std::uint64_t next_serial() {
  static std::atomic<std::uint64_t> last{0};
  return ++last;
}

// MuJoCo's virtual file system. It is 2 MB large, too much for a stack.
class VirtualFiles {
 public:
  VirtualFiles() : vfs_(std::make_unique<mjVFS>()) { mj_defaultVFS(vfs_.get()); }
  ~VirtualFiles() { mj_deleteVFS(vfs_.get()); }
  VirtualFiles(const VirtualFiles&) = delete;
  VirtualFiles& operator=(const VirtualFiles&) = delete;

  // What is wrong with the file, in words; "" when it was added.
  std::string add(const std::string& name, const std::string& content) {
    // MuJoCo takes an empty file for a mistake of the program, not of the author.
    if (content.empty()) return "the file is empty";
    try {
      switch (mj_makeEmptyFileVFS(vfs_.get(), name.c_str(), static_cast<int>(content.size()))) {
        case 1:
          return "there are too many files";
        case 2:
          return "another file has the same name";
      }
    } catch (const MujocoError& error) {
      return error.what();
    }
    std::memcpy(vfs_->filedata[vfs_->nfile - 1], content.data(), content.size());
    return "";
  }

  const mjVFS* get() const { return vfs_.get(); }

 private:
  std::unique_ptr<mjVFS> vfs_;
};

}  // namespace

Model::Model(mjModel* model, std::vector<std::string> warnings)
    : model_(model), warnings_(std::move(warnings)), serial_(next_serial()) {}

std::string Model::name(mjtObj type, int id) const {
  const char* name = mj_id2name(get(), type, id);
  return name == nullptr ? "" : name;
}

int Model::id(mjtObj type, const std::string& name) const {
  return mj_name2id(get(), type, name.c_str());
}

std::vector<std::string> Model::names(mjtObj type) const {
  std::vector<std::string> names;
  for (int i = 0; i < object_count(*get(), type); ++i) {
    if (std::string known = name(type, i); !known.empty()) names.push_back(std::move(known));
  }
  return names;
}

tl::expected<Model, ModelError> load_model_file(const std::string& path) {
  return load(path, nullptr).map_error([&](const std::string& answer) {
    return explain_load_error(answer, path);
  });
}

tl::expected<Model, ModelError> load_model_files(const std::string& name, const ModelFiles& files) {
  install_mujoco_guard();
  const auto main = files.find(name);
  if (main == files.end()) return tl::unexpected(ModelError{name, 0, 0, "file not found"});
  VirtualFiles virtual_files;
  for (const auto& [added, content] : files) {
    const std::string problem = virtual_files.add(added, content);
    if (!problem.empty()) return tl::unexpected(ModelError{added, 0, 0, problem});
  }
  return load(name, virtual_files.get()).map_error([&](const std::string& answer) {
    return explain_load_error(answer, name, main->second);
  });
}

tl::expected<Model, ModelError> load_model_as(const std::string& path, const std::string& mjcf) {
  install_mujoco_guard();
  VirtualFiles virtual_files;
  const std::string problem = virtual_files.add(path.substr(path.find_last_of('/') + 1), mjcf);
  if (!problem.empty()) return tl::unexpected(ModelError{path, 0, 0, problem});
  return load(path, virtual_files.get()).map_error([&](const std::string& answer) {
    return explain_load_error(answer, path);
  });
}

tl::expected<Model, ModelError> load_model_text(const std::string& mjcf) {
  if (mjcf.empty()) return tl::unexpected(ModelError{"", 0, 0, "the model is empty"});
  const std::string name = "model.xml";
  return load_model_files(name, {{name, mjcf}}).map_error([&](ModelError error) {
    if (error.file == name) error.file.clear();
    return error;
  });
}

}  // namespace mjcourse
