// What the course's example programs share: models that free themselves, the
// state as Eigen vectors, and vectors printed the way the lessons show them.
// Read it once, top to bottom; it is all there is.
//
//   const Model model = load_model("joint_zoo");  // models/joint_zoo.xml
//   const Data data = make_data(model);
//   qvel(model, data)[0] = 0.1;  // Eigen, straight into data->qvel
//   mj_step(model, data);        // MuJoCo's own functions take both
//   print("qpos =", qpos(model, data));
//
// Everything is in SI units and radians, as in MuJoCo. Errors are
// std::runtime_error, with MuJoCo's message. handlers.cpp, linked into every
// example, keeps MuJoCo from waiting at the keyboard.
#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace mjcourse {

// An owning pointer to one of MuJoCo's C structures: a unique_ptr that MuJoCo's
// functions accept without a .get(), so that code reads as in MuJoCo's manual.
// It can be moved, not copied, and is never null unless moved from. As with any
// pointer, a const Model is one that cannot be exchanged for another; the
// mjModel behind it can still be written to (model->opt.timestep = 0.001).
template <typename T, void (*Destroy)(T*)>
class Owner {
 public:
  explicit Owner(T* object) : object_(object) {}
  T* operator->() const { return object_.get(); }
  operator T*() const {
    return object_.get();
  }  // implicit, for MuJoCo's functions

 private:
  struct Deleter {
    void operator()(T* object) const { Destroy(object); }
  };
  std::unique_ptr<T, Deleter> object_;
};

using Model = Owner<mjModel, mj_deleteModel>;
using Data = Owner<mjData, mj_deleteData>;

// ---- loading ----------------------------------------------------------------

// The directory of the course's models: the environment variable
// MJCOURSE_MODELS where it is set, else the macro of that name, which
// examples/CMakeLists.txt defines. Throws when there is neither.
inline std::filesystem::path models_directory() {
  if (const char* directory = std::getenv("MJCOURSE_MODELS")) return directory;
#ifdef MJCOURSE_MODELS
  return MJCOURSE_MODELS;
#else
  throw std::runtime_error(
      "where are the models? Set the environment variable MJCOURSE_MODELS to "
      "the "
      "course's models/ directory, or build with examples/CMakeLists.txt");
#endif
}

// Compiles the MJCF file at `path`; `vfs` holds files that are in memory rather
// than on disk, or is null. What MuJoCo warns of while compiling goes to
// stderr.
inline Model load_model_file(const std::string& path,
                             const mjVFS* vfs = nullptr) {
  char message[1000] = "";
  mjModel* model = mj_loadXML(path.c_str(), vfs, message, sizeof message);
  if (model == nullptr) throw std::runtime_error(path + ": " + message);
  if (message[0] != '\0')
    std::fprintf(stderr, "%s: warning: %s\n", path.c_str(), message);
  return Model(model);
}

// Compiles a model of the course by its name: "joint_zoo" is
// models/joint_zoo.xml.
inline Model load_model(std::string_view name) {
  const std::filesystem::path file =
      models_directory() / (std::string(name) + ".xml");
  if (!std::filesystem::exists(file))
    throw std::runtime_error("no model '" + std::string(name) +
                             "': " + file.string() + " is not there");
  return load_model_file(file.string());
}

// Compiles a model from MJCF text; errors speak of "model.xml" and count the
// lines of the text.
inline Model load_model_xml(std::string_view mjcf) {
  const auto destroy = [](mjVFS* vfs) {
    mj_deleteVFS(vfs);
    delete vfs;
  };
  // On the heap: an mjVFS takes two megabytes.
  const std::unique_ptr<mjVFS, decltype(destroy)> vfs(new mjVFS, destroy);
  mj_defaultVFS(vfs.get());
  mj_makeEmptyFileVFS(vfs.get(), "model.xml", static_cast<int>(mjcf.size()));
  std::memcpy(vfs->filedata[0], mjcf.data(), mjcf.size());
  return load_model_file("model.xml", vfs.get());
}

// A fresh state of `model`: qpos at its reference pose (qpos0), everything else
// zero. Positions of bodies and all else that follows from qpos are computed by
// mj_forward or mj_step, not here. Must not outlive the model.
inline Data make_data(const mjModel* model) {
  mjData* data = mj_makeData(model);
  if (data == nullptr)
    throw std::runtime_error(
        "mj_makeData: MuJoCo could not allocate the state");
  return Data(data);
}

// The number of a named thing, say id_of(model, mjOBJ_JOINT, "free").
// mj_name2id answers -1 where there is no such name, a silent bug as an index;
// this throws.
inline int id_of(const mjModel* model, mjtObj type, const char* name) {
  const int id = mj_name2id(model, type, name);
  if (id < 0)
    throw std::runtime_error(std::string("the model has no ") +
                             mju_type2Str(type) + " named '" + name + "'");
  return id;
}

// ---- the state as Eigen vectors ---------------------------------------------

// Views, not copies: writing to one writes to `data`, and it is valid as long
// as `data` is. To keep a value, copy it: `const Eigen::VectorXd q0 =
// qpos(model, data);` (and not `auto`).
using VectorView = Eigen::Map<Eigen::VectorXd>;

// Generalized positions (nq): m, rad, and unit quaternions (w, x, y, z).
inline VectorView qpos(const mjModel* model, mjData* data) {
  return {data->qpos, model->nq};
}
// Generalized velocities (nv): m/s and rad/s.
inline VectorView qvel(const mjModel* model, mjData* data) {
  return {data->qvel, model->nv};
}
// Generalized accelerations (nv), as the last mj_forward or mj_step found them:
// m/s^2 and rad/s^2.
inline VectorView qacc(const mjModel* model, mjData* data) {
  return {data->qacc, model->nv};
}
// Controls (nu), in the unit of each actuator.
inline VectorView ctrl(const mjModel* model, mjData* data) {
  return {data->ctrl, model->nu};
}

// ---- printing ---------------------------------------------------------------

// `x` rounded to `digits` places (1 to 60) without the zeros at its end: 0.5 ->
// "0.5", 2 -> "2.", and never "-0.".
inline std::string rounded(double x, int digits) {
  char buffer[400];  // the largest double has 309 digits before its point
  std::snprintf(buffer, sizeof buffer, "%.*f", std::clamp(digits, 1, 60), x);
  std::string text = buffer;
  if (text.find('.') != std::string::npos)
    text.erase(text.find_last_not_of('0') + 1);
  return text == "-0." ? "0." : text;
}

// A number as Python prints round(x, digits): "1.0", "0.5935".
inline std::string to_text(double x, int digits = 4) {
  const std::string text = rounded(x, digits);
  return text.back() == '.' ? text + '0' : text;
}

// A vector on one line, as NumPy prints one after rounding: "[ 0.1    0.
// -0.025]", points aligned.
inline std::string to_text(const Eigen::Ref<const Eigen::VectorXd>& vector,
                           int digits = 4) {
  std::vector<std::string> numbers;
  std::size_t before = 0, after = 0;  // widest part up to the point; from it on
  const auto point = [](const std::string& text) {
    return std::min(text.find('.'), text.size());
  };
  for (const double x : vector) {
    const std::string& text = numbers.emplace_back(rounded(x, digits));
    before = std::max(before, point(text));
    after = std::max(after, text.size() - point(text));
  }
  std::string line = "[";
  for (const std::string& text : numbers) {
    if (line.size() > 1) line += ' ';
    const std::size_t at = point(text);
    line.append(before - at, ' ')
        .append(text)
        .append(after - (text.size() - at), ' ');
  }
  return line + "]";
}

// One line on stdout: the label, a space, the vector (or number) to four
// places.
inline void print(std::string_view label,
                  const Eigen::Ref<const Eigen::VectorXd>& vector) {
  std::printf("%.*s %s\n", static_cast<int>(label.size()), label.data(),
              to_text(vector).c_str());
}
inline void print(std::string_view label, double x) {
  std::printf("%.*s %s\n", static_cast<int>(label.size()), label.data(),
              to_text(x).c_str());
}

}  // namespace mjcourse
