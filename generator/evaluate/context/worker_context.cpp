#include "evaluate/context/worker_context.h"

#include <re2/re2.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "base/nearest.h"
#include "base/utf8.h"
#include "physics/model_files.h"
#include "script/world.h"

namespace mjcourse {
namespace {

// What of `line` a model's error is about: the word that MuJoCo quotes last ("unrecognized
// attribute: 'poss'"), else the whole line without its indentation.
Span blamed(std::string_view line, const std::string& message) {
  static const RE2 quoted(R"((?s).*'(\w+)'[^']*)");
  if (std::string word; RE2::FullMatch(message, quoted, &word)) {
    for (std::size_t at = 0; (at = line.find(word, at)) != line.npos; ++at) {
      const std::size_t end = at + word.size();
      const bool begins = at == 0 || !is_word_character(line[at - 1]);
      if (begins && (end == line.size() || !is_word_character(line[end]))) return {at, end};
    }
  }
  return {std::min(line.find_first_not_of(" \t"), line.size()), line.size()};
}

}  // namespace

WorkerContext::WorkerContext(const RunContext& run_context)
    : run_context_(run_context), trace_(run_context.root()), files_(run_context.root(), trace_) {}

const Reports& WorkerContext::reports_of(const std::string& example) {
  trace_.program(example);
  return run_context_.reports();
}

Typesetter& WorkerContext::typesetter() {
  if (!typesetter_) typesetter_.emplace(run_context_.script("typeset"), course().macros);
  return *typesetter_;
}

PlotRenderer& WorkerContext::plot_renderer() {
  if (!plot_renderer_) plot_renderer_.emplace(run_context_.script("plot"));
  return *plot_renderer_;
}

ScriptGuard& WorkerContext::script_guard() {
  if (!script_guard_) script_guard_.emplace(run_context_.script("guard"));
  return *script_guard_;
}

// The same over every model: over one that has nothing in it.
const std::vector<std::string>& WorkerContext::script_names() {
  if (script_names_.empty()) {
    Simulation simulation(run_context_.models().text("<mujoco/>").value());
    script_names_ = World(world_bundle(), simulation).names();
  }
  return script_names_;
}

tl::expected<Renderer*, std::string> WorkerContext::renderer() {
  if (!renderer_) {
    tl::expected<Renderer, std::string> made = Renderer::create();
    if (!made) return tl::unexpected(made.error());
    renderer_.emplace(*std::move(made));
  }
  return &*renderer_;
}

ActionContext WorkerContext::action_context() {
  return {run_context_.root(), *run_context_.compiler(), run_context_.actions(), trace_};
}

PageProcess* WorkerContext::page_process() {
  if (run_context_.page() == nullptr) return nullptr;
  if (!page_process_) page_process_.emplace(*run_context_.page());
  return &*page_process_;
}

void WorkerContext::let_go() {
  if (renderer_) renderer_->let_go();
}

void WorkerContext::report_model_file(const ModelError& error, const std::string& path,
                                      const LocatedText& model, const SourceText& lesson,
                                      Diagnostics& diagnostics) {
  // By its name, wherever a link may lead.
  const std::filesystem::path relative =
      std::filesystem::absolute(error.file)
          .lexically_normal()
          .lexically_relative(std::filesystem::absolute(root()).lexically_normal());
  const std::string file = error.file.empty() || relative.empty() ? path : relative.string();
  const Note used{"lesson " + lesson.path() + " uses this model", place_of(lesson, model.span())};
  const auto known = std::find_if(diagnostics.begin(), diagnostics.end(), [&](const auto& d) {
    return d.id == "E-model-mjcf" && d.place.file == file;
  });
  if (known != diagnostics.end()) {
    const bool noted = std::any_of(known->notes.begin(), known->notes.end(), [&](const Note& note) {
      return note.place.file == lesson.path();
    });
    if (!noted) known->notes.push_back(used);
    return;
  }
  Place place{file, error.line, error.column, 1, ""};
  if (const auto text = DiskFiles(root()).read(file); text && error.line > 0) {
    const SourceText source(file, *text);
    const std::size_t start = source.line_start(error.line);
    const Span span = blamed(source.line(error.line), error.message);
    place = place_of(source, {start + span.begin, start + span.end});
  }
  Diagnostic found = error_at(place, "E-model-mjcf", error.message, error.cure);
  found.notes.push_back(used);
  diagnostics.push_back(std::move(found));
}

void WorkerContext::trace_model(const std::string& path) {
  if (!trace_.file(path)) return;
  for (const std::string& file : look_at_model_files(root(), path).files) {
    trace_.file(file);
  }
}

std::optional<Simulation> WorkerContext::simulate(const LocatedText& model,
                                                  const SourceText& lesson,
                                                  Diagnostics& diagnostics) {
  return model.text.starts_with('<') ? simulate_mjcf(model, lesson, diagnostics)
                                     : simulate_named(model, lesson, diagnostics);
}

std::optional<Simulation> WorkerContext::simulate_mjcf(const LocatedText& mjcf,
                                                       const SourceText& lesson,
                                                       Diagnostics& diagnostics) {
  tl::expected<Model, ModelError> loaded = run_context_.models().text(mjcf.text);
  if (loaded) return Simulation(*std::move(loaded));
  const ModelError& error = loaded.error();
  Span span = mjcf.span();
  if (error.line > 0) {
    const SourceText source("", mjcf.text);
    const std::size_t start = source.line_start(error.line);
    const Span part = blamed(source.line(error.line), error.message);
    span = mjcf.span(start + part.begin, start + part.end);
  }
  diagnostics.push_back(
      error_at(place_of(lesson, span), "E-model-mjcf", error.message, error.cure));
  return std::nullopt;
}

std::optional<Simulation> WorkerContext::simulate_named(const LocatedText& model,
                                                        const SourceText& lesson,
                                                        Diagnostics& diagnostics) {
  const std::vector<std::string>& known = course().models;
  if (std::find(known.begin(), known.end(), model.text) == known.end()) {
    diagnostics.push_back(error_at(place_of(lesson, model.span()), "E-model-unknown",
                                   "there is no model `" + model.text + "` in models/",
                                   suggest(model.text, known)));
    return std::nullopt;
  }
  const std::string path = "models/" + model.text + ".xml";
  tl::expected<Model, ModelError> loaded = run_context_.models().file(root(), path);
  if (loaded) {
    trace_model(path);
    return Simulation(*std::move(loaded));
  }
  report_model_file(loaded.error(), path, model, lesson, diagnostics);
  return std::nullopt;
}

}  // namespace mjcourse
