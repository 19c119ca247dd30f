#include "evaluate/lesson_evaluator.h"

#include <utility>
#include <variant>

#include "base/stopwatch.h"
#include "evaluate/chart.h"
#include "evaluate/figure.h"
#include "evaluate/formula.h"
#include "evaluate/image.h"
#include "evaluate/inline_value.h"
#include "evaluate/lab.h"
#include "evaluate/model_listing.h"
#include "evaluate/question.h"

namespace mjcourse {
namespace {

bool may_quote(const Block& block) {
  const auto* figure = std::get_if<Figure>(&block);
  return std::holds_alternative<InlineValue>(block) || std::holds_alternative<Chart>(block) ||
         std::holds_alternative<Quiz>(block) || (figure != nullptr && figure->from);
}

}  // namespace

void LessonEvaluator::run(bool quoting) {
  for (std::size_t i = 0; i < lesson_.blocks.size(); ++i) {
    const Block& block = lesson_.blocks[i];
    if (may_quote(block) != quoting) continue;
    const Stopwatch stopwatch;
    std::visit([&](const auto& known) { evaluate_block(i, known); }, block);
    if (results_.of_block.contains(i)) results_.seconds[i] = stopwatch.seconds();
  }
}

void LessonEvaluator::evaluate_block(std::size_t index, const InlineValue& value) {
  keep(index, evaluate_value(value, lesson_, workshop_, diagnostics_));
}

void LessonEvaluator::evaluate_block(std::size_t index, const Math& math) {
  keep(index, evaluate_formula(math, lesson_, workshop_, diagnostics_));
}

void LessonEvaluator::evaluate_block(std::size_t index, const Lab& lab) {
  progress_.begin("rehearse the lab \"" + lab.title + "\"");
  auto result = evaluate_lab(lab, lesson_, workshop_, diagnostics_);
  if (result && result->pin) results_.pins.push_back(*result->pin);
  keep(index, std::move(result));
  progress_.done();
}

void LessonEvaluator::evaluate_block(std::size_t index, const Figure& figure) {
  progress_.begin("draw a figure of " + lesson_.number);
  auto result = evaluate_figure(figure, lesson_, workshop_, diagnostics_);
  if (result && result->pin) results_.pins.push_back(*result->pin);
  keep(index, std::move(result));
  progress_.done();
}

void LessonEvaluator::evaluate_block(std::size_t index, const Chart& chart) {
  progress_.begin("draw the plot of " + chart.table.text);
  keep(index, evaluate_chart(chart, index, lesson_, workshop_, diagnostics_));
  progress_.done();
}

void LessonEvaluator::evaluate_block(std::size_t index, const Quiz& quiz) {
  progress_.begin("prove the answers of " + quiz.id);
  QuizResult result;
  for (const Question& question : quiz.questions) {
    const Stopwatch stopwatch;
    auto answer = evaluate_question(question, lesson_, workshop_, diagnostics_);
    QuestionResult& kept = result.questions.emplace_back(answer.value_or(QuestionResult{}));
    kept.failed = !answer;
    kept.seconds = stopwatch.seconds();
  }
  results_.of_block[index] = std::move(result);
  progress_.done();
}

void LessonEvaluator::evaluate_block(std::size_t, const Snippet& snippet) {
  workshop_.simulate_named(snippet.model, *lesson_.source, diagnostics_);
}

void LessonEvaluator::evaluate_block(std::size_t index, const ModelExcerpt& excerpt) {
  keep(index, evaluate_excerpt(excerpt, lesson_, workshop_, diagnostics_));
}

void LessonEvaluator::evaluate_block(std::size_t index, const InlineModel& model) {
  keep(index, evaluate_inline_model(model, lesson_, workshop_, diagnostics_));
}

void LessonEvaluator::evaluate_block(std::size_t index, const Image& image) {
  keep(index, evaluate_image(image, lesson_, workshop_.root(), diagnostics_));
}

}  // namespace mjcourse
