// WorkerContext: the tools of one thread that evaluates: the course's files and models, the
// typesetter, the renderer. Each is made when it is first used, and whatever they read is traced.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "actions/native_program.h"
#include "cache/trace.h"
#include "evaluate/context/run_context.h"
#include "physics/renderer.h"
#include "physics/simulation.h"
#include "report/diagnostic.h"
#include "script/plot_renderer.h"
#include "script/script_guard.h"
#include "script/typeset.h"
#include "toolchain/page_process.h"

namespace mjcourse {

class WorkerContext {
 public:
  explicit WorkerContext(const RunContext& run_context);

  const RunContext& run_context() const { return run_context_; }
  const Course& course() const { return run_context_.course(); }
  const std::filesystem::path& root() const { return run_context_.root(); }
  const std::string& world_bundle() const { return run_context_.script("world"); }

  // What the present piece of work has looked at; cleared before each.
  Trace& trace() { return trace_; }
  // The course's.
  const Files& files() const { return files_; }
  // For a block that quotes the program `example`.
  const Reports& reports_of(const std::string& example);

  Typesetter& typesetter();
  PlotRenderer& plot_renderer();
  ScriptGuard& script_guard();
  // What scripts may use of the world.
  const std::vector<std::string>& script_names();

  // For what is compiled and run. There is a compiler.
  ActionContext action_context();
  // Runs programs as a page does; null where the build cannot (RunContext::page).
  PageProcess* page_process();
  // Seconds that it took so far.
  double page_seconds() const { return page_process_ ? page_process_->asked() : 0; }

  // Frees what a large model allocated.
  void let_go();

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
  // Of one that compiles: what comes of another is not kept.
  void trace_model(const std::string& path);
  void report_model_file(const ModelError& error, const std::string& path, const LocatedText& model,
                         const SourceText& lesson, Diagnostics& diagnostics);

  const RunContext& run_context_;
  Trace trace_;
  TracedFiles files_;
  std::optional<Typesetter> typesetter_;
  std::optional<PlotRenderer> plot_renderer_;
  std::optional<ScriptGuard> script_guard_;
  std::vector<std::string> script_names_;
  std::optional<Renderer> renderer_;
  std::optional<PageProcess> page_process_;
};

}  // namespace mjcourse
