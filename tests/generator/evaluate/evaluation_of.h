// Evaluates a course of one lesson in a folder of its own, and shows its mistakes as a terminal
// would.
#pragma once

#include <map>
#include <stdexcept>
#include <string>

#include "base/files.h"
#include "base/temporary_folder.h"
#include "evaluate/claims/claims.h"
#include "evaluate/evaluate.h"
#include "reading_of.h"

namespace mjcourse {

class NoProgress : public Progress {
 public:
  void plan(std::size_t) override {}
  void begin(const std::string&) override {}
  void end(const std::string&) override {}
};

// A ball that falls on nothing, on a rail with a motor.
inline constexpr const char* kBall = R"(<mujoco>
  <worldbody>
    <body name="ball" pos="0 0 1"><freejoint name="free"/><geom size="0.1"/></body>
    <body name="cart"><joint name="slide" type="slide"/><geom size="0.1"/></body>
  </worldbody>
  <actuator><motor name="motor" joint="slide"/></actuator>
</mujoco>
)";

class EvaluationOf {
 public:
  // The lesson's body begins in line 4; `files` are path → bytes, beside models/ball.xml. What is
  // found is kept in `store`, where there is one; `page` has a page's compiler, where that is.
  explicit EvaluationOf(const std::string& body,
                        const std::map<std::string, std::string>& files = {},
                        Store* store = nullptr, std::filesystem::path page = {})
      : store_(store), page_(std::move(page)) {
    write("content/course.yaml", "title: C\nlevels: [{folder: 1-a, title: A, lessons: [1.1-x]}]\n");
    write(kLessonPath, "---\ntitle: T\n---\n" + body);
    write("models/ball.xml", kBall);
    for (const auto& [path, bytes] : files) write(path, bytes);
    Diagnostics reading;
    course_ = read_course(DiskFiles(folder_.path()), reading, core_count(), 0);
    if (!reading.empty()) throw std::runtime_error("the lesson itself is wrong\n" + shown(reading));
    again();
  }

  void again() {
    NoProgress progress;
    const DiskFiles assets(MJCOURSE_ASSETS);
    EvaluationSettings settings{folder_.path(), assets, store_};
    settings.page = page_;
    evaluation_ = evaluate(course_.value(), settings, progress);
    claim_prose(*course_, DiskFiles(folder_.path()), evaluation_);
  }

  const Diagnostics& diagnostics() const { return evaluation_.diagnostics; }
  std::string mistakes() const { return shown(evaluation_.diagnostics); }
  const Evaluation& evaluation() const { return evaluation_; }
  const Tally& tally() const { return evaluation_.lessons.at(0).tally; }
  const Claims& claims() const { return evaluation_.lessons.at(0).claims; }
  const Versions& versions() const { return evaluation_.versions; }

  // The result of the only block that has one of type T.
  template <typename T>
  const T& result() const {
    for (const auto& [index, result] : evaluation_.lessons.at(0).of_block) {
      if (const auto* found = std::get_if<T>(&result)) return *found;
    }
    throw std::runtime_error("no such result\n" + mistakes());
  }

 private:
  void write(const std::string& path, const std::string& bytes) const {
    write_file(folder_.path() / path, bytes);
  }

  Store* store_;
  std::filesystem::path page_;
  TemporaryFolder folder_;
  std::optional<Course> course_;
  Evaluation evaluation_;
};

// What is wrong with `body`.
inline std::string evaluated_mistakes(const std::string& body,
                                      const std::map<std::string, std::string>& files = {}) {
  return EvaluationOf(body, files).mistakes();
}

}  // namespace mjcourse
