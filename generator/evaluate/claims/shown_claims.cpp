// The claims of what a reader looks at, plays with and answers.
// Tested by tests/generator/evaluate/claims/claims_test.cpp.
#include <nlohmann/json.hpp>
#include <utility>

#include "evaluate/claims/claim_text.h"
#include "evaluate/claims/lesson_claims.h"

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

void LessonClaims::add(std::size_t i, const ModelExcerpt& excerpt) {
  const std::string file = "models/" + excerpt.model.text + ".xml";
  Claim claim = begin(Kind::listing, i, "a part of " + file, fence(excerpt.span));
  claim.how =
      "compared line by line with " + file + ", which MuJoCo " + versions().mujoco + " compiles";
  claim.limits = "indentation and blank lines do not count";
  finish(std::move(claim), results_.get<ModelResult>(i) != nullptr,
         {sources_.model(excerpt.model.text)});
}

void LessonClaims::add(std::size_t i, const InlineModel& model) {
  Claim claim = begin(Kind::listing, i, "a model", fence(model.span));
  const auto* result = results_.get<ModelResult>(i);
  claim.how = "compiled by MuJoCo " + versions().mujoco;
  if (!model.compiles) claim.how += ", which refuses it, as the lesson says";
  finish(std::move(claim), result != nullptr, {result == nullptr ? "" : result->refusal});
}

void LessonClaims::add(std::size_t i, const Lab& lab) {
  const std::string title = "\u201c" + lab.title + "\u201d";
  const Span extent = fence(lab.span);
  const auto* result = results_.get<LabResult>(i);
  Claim claim = begin(Kind::lab, i, "the lab " + title, extent);
  if (result != nullptr) claim.how = how_rehearsed(lab, *result);
  claim.limits = "each control in each of its values by itself, a slider at both ends";
  const std::string model = sources_.model(lab.model.text);
  finish(std::move(claim), result != nullptr,
         {model, sources_.models_named_in(written(extent)),
          result == nullptr ? "" : text_of(*result)});
  if (result == nullptr) return;
  Claim picture = begin(Kind::picture, i, "the picture of the lab " + title, extent);
  picture.seconds = 0;
  picture.how = "drawn by MuJoCo " + versions().mujoco;
  finish(std::move(picture), result->poster.has_value(),
         {model, result->poster ? result->poster->png.hash() : ""});
}

void LessonClaims::add(std::size_t i, const Figure& figure) {
  Claim claim = begin(Kind::picture, i, as_title("a figure: " + figure.alt), fence(figure.span));
  const auto* result = results_.get<FigureResult>(i);
  claim.how = how_drawn(figure, versions());
  const std::string models = sources_.models_named_in(written(claim.extent));
  finish(std::move(claim), result != nullptr,
         {sources_.model(figure.model.text), models,
          result == nullptr ? "" : result->poster.png.hash() + result->film.hash()});
}

void LessonClaims::add(std::size_t i, const Plot& plot) {
  Claim claim = begin(Kind::plot, i, as_title("a plot: " + plot.alt), fence(plot.span));
  const auto* result = results_.get<PlotResult>(i);
  if (result != nullptr) claim.how = how_plotted(plot, *result);
  finish(std::move(claim), result != nullptr, {result == nullptr ? "" : result->drawings.wide.svg});
}

void LessonClaims::add(std::size_t i, const Image& image) {
  Claim claim =
      begin(Kind::image, i, as_title(image.file.text + ": " + image.alt), image.file.span());
  const auto* result = results_.get<ImageResult>(i);
  claim.status = image.title.empty() ? Status::asserted : Status::cited;
  claim.reason = image.title;
  finish(std::move(claim), result != nullptr, {result == nullptr ? "" : result->hash});
}

void LessonClaims::add(std::size_t i, const Quiz& quiz) {
  const auto* results = results_.get<QuizResult>(i);
  for (std::size_t q = 0; q < quiz.questions.size(); ++q) {
    const Question& question = quiz.questions[q];
    const QuestionResult result = results != nullptr ? results->questions[q] : QuestionResult{};
    Claim claim = begin(Kind::answer, i,
                        as_title("question " + std::to_string(q + 1) + ": " +
                                 (question.text ? plain_text(question.text.get()) : "")),
                        question.span);
    claim.part = q;
    claim.seconds = result.seconds;
    claim.limits = limits_of_answer(question);
    claim.how = how_proved(question, result);
    if (!result.proved) {
      claim.status = Status::asserted;
      claim.reason = result.because;
    }
    finish(std::move(claim), results != nullptr && !result.failed,
           {sources_.models_named_in(written(question.span))});
  }
}

}  // namespace mjcourse
