#include "evaluate/claims/shown_claims.h"

#include <nlohmann/json.hpp>
#include <utility>

#include "evaluate/claims/claim_text.h"

namespace mjcourse {
namespace {

using Kind = Claim::Kind;
using Status = Claim::Status;

std::string text_of(const LabResult& result) {
  nlohmann::json all{{"readouts", result.readouts}, {"traces", result.traces}};
  for (const LabRunResult& run : result.runs) {
    nlohmann::json readings = nlohmann::json::array();
    for (const LabReading& reading : run.readings) {
      readings.push_back({reading.steps, reading.values});
    }
    all["runs"].push_back(std::move(readings));
  }
  if (result.predicted) all["predicted"] = *result.predicted;
  return all.dump();
}

}  // namespace

void claim(const ModelExcerpt& excerpt, std::size_t i, ClaimContext& context) {
  const std::string file = "models/" + excerpt.model.text + ".xml";
  Claim made = context.begin(Kind::listing, i, "a part of " + file, context.fence(excerpt.span));
  made.how = "compared line by line with " + file + ", which MuJoCo " + context.versions().mujoco +
             " compiles";
  made.limits = "indentation and blank lines do not count";
  context.finish(std::move(made), context.results.get<ModelResult>(i) != nullptr,
                 {context.sources.model(excerpt.model.text)});
}

void claim(const InlineModel& model, std::size_t i, ClaimContext& context) {
  Claim made = context.begin(Kind::listing, i, "a model", context.fence(model.span));
  const auto* result = context.results.get<ModelResult>(i);
  made.how = "compiled by MuJoCo " + context.versions().mujoco;
  if (!model.compiles) made.how += ", which refuses it, as the lesson says";
  context.finish(std::move(made), result != nullptr, {result == nullptr ? "" : result->refusal});
}

void claim(const Lab& lab, std::size_t i, ClaimContext& context) {
  const std::string title = "\u201c" + lab.title + "\u201d";
  const Span extent = context.fence(lab.span);
  const auto* result = context.results.get<LabResult>(i);
  Claim made = context.begin(Kind::lab, i, "the lab " + title, extent);
  if (result != nullptr) made.how = how_rehearsed(lab, *result);
  made.limits = "each control in each of its values by itself, a slider at both ends";
  const std::string model = context.sources.model(lab.model.text);
  context.finish(std::move(made), result != nullptr,
                 {model, context.sources.models_named_in(context.written(extent)),
                  result == nullptr ? "" : text_of(*result)});
  if (result == nullptr) return;
  Claim picture = context.begin(Kind::picture, i, "the picture of the lab " + title, extent);
  picture.seconds = 0;
  picture.how = "drawn by MuJoCo " + context.versions().mujoco;
  context.finish(std::move(picture), result->poster.has_value(),
                 {model, result->poster ? result->poster->png.hash() : ""});
}

void claim(const Figure& figure, std::size_t i, ClaimContext& context) {
  Claim made = context.begin(Kind::picture, i, as_title("a figure: " + figure.alt),
                             context.fence(figure.span));
  const auto* result = context.results.get<FigureResult>(i);
  made.how = how_drawn(figure, context.versions());
  const std::string models = context.sources.models_named_in(context.written(made.extent));
  context.finish(std::move(made), result != nullptr,
                 {context.sources.model(figure.model.text), models,
                  result == nullptr ? "" : result->poster.png.hash() + result->film.hash()});
}

void claim(const Plot& plot, std::size_t i, ClaimContext& context) {
  Claim made =
      context.begin(Kind::plot, i, as_title("a plot: " + plot.alt), context.fence(plot.span));
  const auto* result = context.results.get<PlotResult>(i);
  if (result != nullptr) made.how = how_plotted(plot, *result);
  context.finish(std::move(made), result != nullptr,
                 {result == nullptr ? "" : result->drawings.wide.svg});
}

void claim(const Image& image, std::size_t i, ClaimContext& context) {
  Claim made = context.begin(Kind::image, i, as_title(image.file.text + ": " + image.alt),
                             image.file.span());
  const auto* result = context.results.get<ImageResult>(i);
  made.status = image.title.empty() ? Status::asserted : Status::cited;
  made.reason = image.title;
  context.finish(std::move(made), result != nullptr, {result == nullptr ? "" : result->hash});
}

void claim(const Quiz& quiz, std::size_t i, ClaimContext& context) {
  const auto* results = context.results.get<QuizResult>(i);
  for (std::size_t q = 0; q < quiz.questions.size(); ++q) {
    const Question& question = quiz.questions[q];
    const QuestionResult result = results != nullptr ? results->questions[q] : QuestionResult{};
    Claim made = context.begin(Kind::answer, i,
                               as_title("question " + std::to_string(q + 1) + ": " +
                                        (question.text ? plain_text(question.text.get()) : "")),
                               question.span);
    made.part = q;
    made.seconds = result.seconds;
    made.limits = limits_of_answer(question);
    made.how = how_proved(question, result);
    if (!result.proved) {
      made.status = Status::asserted;
      made.reason = result.because;
    }
    context.finish(std::move(made), results != nullptr && !result.failed,
                   {context.sources.models_named_in(context.written(question.span))});
  }
}

}  // namespace mjcourse
