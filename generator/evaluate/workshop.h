// Workshop: the tools that evaluating shares: the course's files and models, the typesetter, the
// renderer, the compiler. One workshop serves one thread.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "base/files.h"
#include "course/course.h"
#include "evaluate/reports.h"
#include "physics/renderer.h"
#include "physics/simulation.h"
#include "report/diagnostic.h"
#include "script/chart_press.h"
#include "script/typeset.h"

namespace mjcourse {

class Workshop {
 public:
  // `root` is the course's folder on the disk; `assets` holds script/*.js.
  Workshop(const Course& course, std::filesystem::path root, const Files& assets);

  const Course& course() const { return course_; }
  const std::filesystem::path& root() const { return root_; }
  Typesetter& typesetter() { return typesetter_; }
  const std::string& world_bundle() const { return world_bundle_; }

  ChartPress& chart_press() { return chart_press_; }

  // Complete once all examples were run.
  Reports& reports() { return reports_; }

  // The off-screen renderer, made at first use; or why there is none.
  tl::expected<Renderer*, std::string> renderer();

  // A fresh simulation of what `model` says: a model's name, or MJCF where it starts with `<`.
  // Nothing (reported) when there is no such model or it does not compile; a model file's own
  // mistake is reported once, at its own line, with a note for each lesson that uses it.
  std::optional<Simulation> simulate(const LocatedText& model, const SourceText& lesson,
                                     Diagnostics& diagnostics);

  // The same, of a name alone and of MJCF alone.
  std::optional<Simulation> simulate_named(const LocatedText& model, const SourceText& lesson,
                                           Diagnostics& diagnostics);
  std::optional<Simulation> simulate_mjcf(const LocatedText& mjcf, const SourceText& lesson,
                                          Diagnostics& diagnostics);

 private:
  void report_model_file(const ModelError& error, const std::string& path, const LocatedText& model,
                         const SourceText& lesson, Diagnostics& diagnostics);

  const Course& course_;
  std::filesystem::path root_;
  std::string world_bundle_;
  Typesetter typesetter_;
  ChartPress chart_press_;
  Reports reports_;
  std::optional<Renderer> renderer_;
};

// Bytes of the bundle script/NAME.js; throws std::runtime_error when the assets were not built.
std::string script_bundle(const Files& assets, const std::string& name);

}  // namespace mjcourse
