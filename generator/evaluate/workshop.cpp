#include "evaluate/workshop.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "base/nearest.h"
#include "physics/model.h"

namespace mjcourse {

std::string script_bundle(const Files& assets, const std::string& name) {
  tl::expected<std::string, std::string> bytes = assets.read("script/" + name + ".js");
  if (!bytes) throw std::runtime_error("the site's assets are not built: " + bytes.error());
  return *std::move(bytes);
}

Workshop::Workshop(const Course& course, std::filesystem::path root, const Files& assets)
    : course_(course),
      root_(std::move(root)),
      world_bundle_(script_bundle(assets, "world")),
      typesetter_(script_bundle(assets, "typeset"), course.macros) {}

tl::expected<Renderer*, std::string> Workshop::renderer() {
  if (!renderer_) {
    tl::expected<Renderer, std::string> made = Renderer::create();
    if (!made) return tl::unexpected(made.error());
    renderer_.emplace(*std::move(made));
  }
  return &*renderer_;
}

void Workshop::report_model_file(const ModelError& error, const std::string& path,
                                 const LocatedText& model, const SourceText& lesson,
                                 Diagnostics& diagnostics) {
  if (!reported_.insert(path).second) return;
  std::error_code failure;
  const std::filesystem::path relative =
      std::filesystem::relative(error.file.empty() ? root_ / path : std::filesystem::path(error.file),
                                root_, failure);
  const std::string file = failure || relative.empty() ? path : relative.string();
  Place place{file, error.line, error.column, 1, ""};
  if (const auto text = DiskFiles(root_).read(file); text && error.line > 0) {
    const SourceText source(file, *text);
    place.excerpt = source.line(error.line);
    // Without a column the whole element is meant.
    const std::size_t first = place.excerpt.find_first_not_of(" \t");
    if (place.column == 0 && first != std::string::npos) {
      place.column = static_cast<int>(first) + 1;
      place.width = static_cast<int>(place.excerpt.size() - first);
    }
  }
  const Note used{"lesson " + lesson.path() + " uses this model", place_of(lesson, model.span())};
  diagnostics.push_back({"E-model-mjcf", Severity::error, place, error.message, "", {used}, ""});
}

std::optional<Simulation> Workshop::simulate(const LocatedText& model, const SourceText& lesson,
                                             Diagnostics& diagnostics) {
  if (model.text.starts_with('<')) {
    tl::expected<Model, ModelError> loaded = load_model_text(model.text);
    if (loaded) return Simulation(*std::move(loaded));
    const ModelError& error = loaded.error();
    const Span span = error.line > 0 ? model.span_at(error.line, std::max(1, error.column), 1)
                                     : model.span();
    diagnostics.push_back({"E-model-mjcf", Severity::error, place_of(lesson, span), error.message,
                           "", {}, ""});
    return std::nullopt;
  }
  const std::vector<std::string>& known = course_.models;
  if (std::find(known.begin(), known.end(), model.text) == known.end()) {
    diagnostics.push_back({"E-model-unknown", Severity::error, place_of(lesson, model.span()),
                           "there is no model `" + model.text + "` in models/", "", {},
                           suggest(model.text, known)});
    return std::nullopt;
  }
  const std::string path = "models/" + model.text + ".xml";
  tl::expected<Model, ModelError> loaded = load_model_file((root_ / path).string());
  if (loaded) return Simulation(*std::move(loaded));
  report_model_file(loaded.error(), path, model, lesson, diagnostics);
  return std::nullopt;
}

}  // namespace mjcourse
