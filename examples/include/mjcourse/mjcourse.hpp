// What the course's example programs share: models that free themselves, the
// state as Eigen vectors, vectors printed the way the lessons show them, and
// what a program tells its lesson.
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
#include <cmath>
#include <concepts>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <initializer_list>
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

// ---- telling the lesson -----------------------------------------------------

// What a program finds, its lesson can quote: after result("error", x), the
// lesson's `{name_of_the_program} error` is x. While the lesson is built, the
// environment variable MJCOURSE_RECORDS names a file, which gets a line of JSON
// for each record; everywhere else the three reporters below do nothing.

// JSON has no word for what is not finite: it becomes null, which the build of
// the lesson refuses.
inline std::string to_json(double x) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.17g", x);
  return std::isfinite(x) ? buffer : "null";
}
inline std::string to_json(std::string_view text) {
  std::string json = "\"";
  for (const char c : text) {
    char code[8];
    std::snprintf(code, sizeof code, "\\u%04x", static_cast<unsigned char>(c));
    const bool special = c == '"' || c == '\\' || (c >= 0 && c < ' ');
    json += special ? std::string(code) : std::string(1, c);
  }
  return json + '"';
}
inline std::string to_json(const Eigen::Ref<const Eigen::VectorXd>& vector) {
  std::string json;
  for (const double x : vector)
    json += (json.empty() ? "[" : ", ") + to_json(x);
  return json.empty() ? "[]" : json + "]";
}

inline void record(const char* kind, std::string_view name,
                   const std::string& json) {
  const char* path = std::getenv("MJCOURSE_RECORDS");
  if (path == nullptr) return;
  std::ofstream file(path, std::ios::app);
  file << "{\"" + std::string(kind) + "\": " + to_json(name) +
              ", \"value\": " + json + "}\n"
       << std::flush;
  if (!file) throw std::runtime_error(std::string("cannot write to ") + path);
}

// A number, a text or a vector that the lesson may speak of, by a name made of
// letters, digits and _ that no other result of the program has.
inline void result(std::string_view name, double x) {
  record("result", name, to_json(x));
}
// A whole number to its last digit, which a double has up to 2^53 only.
template <std::integral Whole>
void result(std::string_view name, Whole x) {
  record("result", name, std::to_string(x));
}
inline void result(std::string_view name, std::string_view text) {
  record("result", name, to_json(text));
}
inline void result(std::string_view name,
                   const Eigen::Ref<const Eigen::VectorXd>& vector) {
  record("result", name, to_json(vector));
}

// A table for the lesson to plot; its columns have names and are equally long:
// table("energy", {{"time", t}, {"kinetic", e}}).
struct Column {
  Column(std::string_view title, const Eigen::Ref<const Eigen::VectorXd>& v)
      : name(title), values(v) {}
  Column(std::string_view title, const std::vector<double>& v)
      : name(title),
        values(Eigen::Map<const Eigen::VectorXd>(
            v.data(), static_cast<Eigen::Index>(v.size()))) {}
  std::string name;
  Eigen::VectorXd values;
};
inline void table(std::string_view name,
                  std::initializer_list<Column> columns) {
  std::string json;
  for (const auto& [title, values] : columns) {
    json += json.empty() ? "[" : ", ";
    json += "[" + to_json(title) + ", " + to_json(values) + "]";
  }
  record("table", name, json.empty() ? "[]" : json + "]");
}

// The state as it is now, for the lesson to draw.
inline void snapshot(std::string_view name, const mjModel* model,
                     const mjData* data) {
  std::string json = "{\"time\": " + to_json(data->time);
  const auto add = [&](const char* field, const mjtNum* numbers, int count) {
    json += ", \"" + std::string(field) +
            "\": " + to_json(Eigen::Map<const Eigen::VectorXd>(numbers, count));
  };
  add("qpos", data->qpos, model->nq);
  add("qvel", data->qvel, model->nv);
  add("act", data->act, model->na);
  add("ctrl", data->ctrl, model->nu);
  add("mocap_pos", data->mocap_pos, 3 * model->nmocap);
  add("mocap_quat", data->mocap_quat, 4 * model->nmocap);
  record("snapshot", name, json + "}");
}

// ---- judging what a reader wrote ---------------------------------------------

// An exercise's program checks what its reader wrote: expect(x > 0, "the box
// falls"). The lesson and `mjcourse try` show each check with its mark; without
// them, the program says on stderr at its end what holds and what does not.

struct Check {
  std::string what;     // should hold
  bool holds;           // each time it was checked
  std::string meaning;  // that it does not
  std::string found;    // the values of the first that does not
};

// The checks that this process has made, in their order.
class Checks {
 public:
  // True where this is the first check of that name, or the first that fails.
  bool add(const Check& check) {
    for (Check& known : all_) {
      if (known.what != check.what) continue;
      const bool is_news = known.holds && !check.holds;
      if (is_news) known = check;
      return is_news;
    }
    all_.push_back(check);
    return true;
  }

  ~Checks() {
    if (std::getenv("MJCOURSE_RECORDS") != nullptr) return;
    std::fflush(stdout);
    for (const Check& check : all_) {
      std::fprintf(stderr, "%s %s\n", check.holds ? "[x]" : "[ ]",
                   check.what.c_str());
      for (const std::string& words : {check.meaning, check.found})
        if (!check.holds && !words.empty())
          std::fprintf(stderr, "    %s\n", words.c_str());
    }
  }

 private:
  std::vector<Check> all_;
};
inline Checks checks;

// Reports a check; gives whether it holds. Calls with the same `what`, on other
// models or seeds, are one check, which holds when all of them do.
inline bool add_check(const Check& check, double points, int line) {
  if (checks.add(check))
    record("check", check.what,
           "{\"holds\": " + std::string(check.holds ? "true" : "false") +
               ", \"meaning\": " + to_json(check.meaning) + ", \"found\": " +
               to_json(check.found) + ", \"points\": " + to_json(points) +
               ", \"line\": " + std::to_string(line) + "}");
  return check.holds;
}

// `what` should hold, and `meaning` is what it means if it does not: "the force
// is counted twice". A hand-in gets `points` for it.
inline bool expect(bool holds, const std::string& what,
                   const std::string& meaning = "", double points = 1,
                   int line = __builtin_LINE()) {
  return add_check({what, holds, meaning, ""}, points, line);
}

// What expect_near finds; of long vectors, the two numbers that differ most.
inline std::string how_far(double value, double expected, double tolerance) {
  char text[160];
  std::snprintf(text, sizeof text,
                "it is %.6g, and should be %.6g ± %.2g: off by %.2g", value,
                expected, tolerance, std::abs(value - expected));
  return text;
}

inline std::string how_far(const Eigen::Ref<const Eigen::VectorXd>& value,
                           const Eigen::Ref<const Eigen::VectorXd>& expected,
                           double tolerance) {
  constexpr int few = 7;
  if (value.size() != expected.size())
    return "it has " + std::to_string(value.size()) +
           " numbers, and should have " + std::to_string(expected.size());
  if (value.size() == 0) return "";
  Eigen::Index most = 0;
  const double off = (value - expected).cwiseAbs().maxCoeff(&most);
  if (value.size() > few)
    return "of its number [" + std::to_string(most) + "], " +
           how_far(value[most], expected[most], tolerance);
  char text[60];
  std::snprintf(text, sizeof text, " ± %.2g: off by %.2g", tolerance, off);
  return "it is " + to_text(value, 6) + ", and should be " +
         to_text(expected, 6) + text;
}

// `value` should be at most `tolerance` away from `expected`, and finite. What
// is expected does not depend on what the reader wrote (see expect_alike).
inline bool expect_near(double value, double expected, double tolerance,
                        const std::string& what,
                        const std::string& meaning = "", double points = 1,
                        int line = __builtin_LINE()) {
  const bool near = std::abs(value - expected) <= tolerance;
  return add_check(
      {what, near, meaning, near ? "" : how_far(value, expected, tolerance)},
      points, line);
}

// Each number of the vector. No vector of another length is near.
inline bool expect_near(const Eigen::Ref<const Eigen::VectorXd>& value,
                        const Eigen::Ref<const Eigen::VectorXd>& expected,
                        double tolerance, const std::string& what,
                        const std::string& meaning = "", double points = 1,
                        int line = __builtin_LINE()) {
  const bool near = value.size() == expected.size() &&
                    ((value - expected).array().abs() <= tolerance).all();
  return add_check(
      {what, near, meaning, near ? "" : how_far(value, expected, tolerance)},
      points, line);
}

// The same of two values that both depend on what the reader wrote, where many
// answers are right: a period, and twice that of another length.
template <typename A, typename B>
bool expect_alike(const A& value, const B& other, double tolerance,
                  const std::string& what, const std::string& meaning = "",
                  double points = 1, int line = __builtin_LINE()) {
  return expect_near(value, other, tolerance, what, meaning, points, line);
}

// A number for std::mt19937 and its like, of which checks draw their inputs: 1,
// unless `mjcourse grade` runs the program, which gives another each time.
inline unsigned seed() {
  const char* number = std::getenv("MJCOURSE_SEED");
  return number == nullptr
             ? 1
             : static_cast<unsigned>(std::strtoul(number, nullptr, 10));
}

}  // namespace mjcourse
