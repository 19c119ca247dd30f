#include "evaluate/scenes/model_listing.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

#include "evaluate/scenes/excerpt_match.h"
#include "physics/vetted_model.h"

namespace mjcourse {
namespace {

// Line `number` without its indentation.
Span span_of_line(const SourceText& text, int number) {
  const std::size_t start = text.line_start(number);
  const std::string_view line = text.line(number);
  return {start + std::min(line.find_first_not_of(" \t"), line.size()), start + line.size()};
}

}  // namespace

std::optional<ModelResult> evaluate_excerpt(const ModelExcerpt& excerpt, const Lesson& lesson,
                                            WorkerContext& worker_context,
                                            Diagnostics& diagnostics) {
  if (!worker_context.simulate_named(excerpt.model, *lesson.source, diagnostics))
    return std::nullopt;
  const std::string path = "models/" + excerpt.model.text + ".xml";
  const SourceText file(path, read_again(worker_context.files(), path));
  const Place fence = place_of(*lesson.source, excerpt.span);
  if (excerpt.text.text.find_first_not_of(" \n") == std::string::npos) {
    diagnostics.push_back(error_at(fence, "E-excerpt-empty", "this excerpt shows nothing",
                                   "copy lines of " + path + " into it"));
    return std::nullopt;
  }
  const auto mismatch = find_excerpt_mismatch(excerpt.text.text, file.text());
  if (!mismatch) return ModelResult{};
  const Span line = span_of_line(SourceText("", excerpt.text.text), mismatch->excerpt);
  Diagnostic found = error_at(place_of(*lesson.source, excerpt.text.span(line.begin, line.end)),
                              "E-excerpt-differs", "this line is not in " + path + ", or not here",
                              "copy it from there; a line `…` stands for lines left out");
  if (mismatch->whole > 0) {
    found.notes.push_back({"the file has", place_of(file, span_of_line(file, mismatch->whole))});
  }
  diagnostics.push_back(std::move(found));
  return std::nullopt;
}

std::optional<ModelResult> evaluate_inline_model(const InlineModel& model, const Lesson& lesson,
                                                 WorkerContext& worker_context,
                                                 Diagnostics& diagnostics) {
  if (model.compiles) {
    const auto simulation = worker_context.simulate_mjcf(model.text, *lesson.source, diagnostics);
    return simulation ? std::optional(ModelResult{}) : std::nullopt;
  }
  const tl::expected<Model, ModelError> loaded = load_vetted_text(model.text.text);
  if (loaded) {
    diagnostics.push_back(error_at(place_of(*lesson.source, model.span), "E-model-compiles",
                                   "the model compiles, but the lesson says that it does not",
                                   "remove `expect=error`, or correct what the lesson says"));
    return std::nullopt;
  }
  const ModelError& error = loaded.error();
  return ModelResult{(error.line > 0 ? "line " + std::to_string(error.line) + ": " : "") +
                     error.message + "\n"};
}

}  // namespace mjcourse
