#include "evaluate/evaluate.h"

#include <map>
#include <optional>
#include <utility>

#include "base/stopwatch.h"
#include "evaluate/chart.h"
#include "evaluate/claims.h"
#include "evaluate/example_crew.h"
#include "evaluate/figure.h"
#include "evaluate/formula.h"
#include "evaluate/image.h"
#include "evaluate/inline_value.h"
#include "evaluate/lab.h"
#include "evaluate/model_listing.h"
#include "evaluate/output.h"
#include "evaluate/question.h"
#include "evaluate/region.h"
#include "evaluate/shown_program.h"
#include "evaluate/workshop.h"
#include "physics/mujoco_api.h"

namespace mjcourse {
namespace {

bool may_quote(const Block& block) {
  const auto* figure = std::get_if<Figure>(&block);
  return std::holds_alternative<InlineValue>(block) || std::holds_alternative<Chart>(block) ||
         std::holds_alternative<Quiz>(block) || (figure != nullptr && figure->from);
}

// What one lesson's formulas, labs, figures, questions and inline values come to.
class LessonEvaluator {
 public:
  LessonEvaluator(const Lesson& lesson, Workshop& workshop, Progress& progress,
                  LessonResults& results, Diagnostics& diagnostics)
      : lesson_(lesson),
        workshop_(workshop),
        progress_(progress),
        results_(results),
        diagnostics_(diagnostics) {}

  // First what needs no example, then what may quote one.
  void run_beside_examples() { run(false); }
  void run_after_examples() { run(true); }

 private:
  void run(bool quoting) {
    for (std::size_t i = 0; i < lesson_.blocks.size(); ++i) {
      const Block& block = lesson_.blocks[i];
      if (may_quote(block) != quoting) continue;
      const Stopwatch stopwatch;
      std::visit([&](const auto& known) { evaluate_block(i, known); }, block);
      if (results_.of_block.contains(i)) results_.seconds[i] = stopwatch.seconds();
    }
  }

  void evaluate_block(std::size_t index, const InlineValue& value) {
    auto result = evaluate_value(value, lesson_, workshop_, diagnostics_);
    if (!result) return;
    results_.of_block[index] = *std::move(result);
  }
  void evaluate_block(std::size_t index, const Math& math) {
    auto result = evaluate_formula(math, lesson_, workshop_, diagnostics_);
    if (!result) return;
    results_.of_block[index] = *std::move(result);
  }
  void evaluate_block(std::size_t index, const Lab& lab) {
    progress_.begin("rehearse the lab \"" + lab.title + "\"");
    if (auto result = evaluate_lab(lab, lesson_, workshop_, diagnostics_)) {
      if (result->pin) results_.pins.push_back(*result->pin);
      results_.of_block[index] = *std::move(result);
    }
    progress_.done();
  }
  void evaluate_block(std::size_t index, const Figure& figure) {
    progress_.begin("draw a figure of " + lesson_.number);
    if (auto result = evaluate_figure(figure, lesson_, workshop_, diagnostics_)) {
      if (result->pin) results_.pins.push_back(*result->pin);
      results_.of_block[index] = *std::move(result);
    }
    progress_.done();
  }
  void evaluate_block(std::size_t index, const Chart& chart) {
    progress_.begin("draw the plot of " + chart.table.text);
    if (auto result = evaluate_chart(chart, index, lesson_, workshop_, diagnostics_)) {
      ++results_.tally.plots;
      results_.of_block[index] = *std::move(result);
    }
    progress_.done();
  }
  void evaluate_block(std::size_t index, const Quiz& quiz) {
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
  void evaluate_block(std::size_t, const Snippet& snippet) {
    workshop_.simulate_named(snippet.model, *lesson_.source, diagnostics_);
  }
  void evaluate_block(std::size_t index, const ModelExcerpt& excerpt) {
    add_model(index, evaluate_excerpt(excerpt, lesson_, workshop_, diagnostics_));
  }
  void evaluate_block(std::size_t index, const InlineModel& model) {
    add_model(index, evaluate_inline_model(model, lesson_, workshop_, diagnostics_));
  }
  void evaluate_block(std::size_t index, const Image& image) {
    auto result = evaluate_image(image, lesson_, workshop_.root(), diagnostics_);
    if (result) results_.of_block[index] = *std::move(result);
  }
  void add_model(std::size_t index, std::optional<ModelResult> result) {
    if (!result) return;
    results_.of_block[index] = *std::move(result);
  }
  // Nothing to find out here: examples and their outputs have a crew of their own.
  template <typename Other>
  void evaluate_block(std::size_t, const Other&) {}

  const Lesson& lesson_;
  Workshop& workshop_;
  Progress& progress_;
  LessonResults& results_;
  Diagnostics& diagnostics_;
};

// Hold the outputs that the lesson states against what its example printed.
void compare_outputs(const Lesson& lesson, LessonResults& results, Diagnostics& diagnostics) {
  for (std::size_t i = 0; i < lesson.blocks.size(); ++i) {
    const auto* output = std::get_if<Output>(&lesson.blocks[i]);
    const auto* example = output != nullptr ? results.get<ExampleResult>(output->example) : nullptr;
    if (example == nullptr) continue;
    if (auto result = evaluate_output(*output, *example, lesson, diagnostics)) {
      results.of_block[i] = *result;
    }
  }
}

// Labs, figures, charts and quizzes; the crew's programs come on top.
int count_tasks(const Course& course) {
  int tasks = 0;
  for (const Lesson& lesson : course.lessons) {
    for (const Block& block : lesson.blocks) {
      const bool counts =
          std::holds_alternative<Lab>(block) || std::holds_alternative<Figure>(block) ||
          std::holds_alternative<Chart>(block) || std::holds_alternative<Quiz>(block);
      if (counts) ++tasks;
    }
  }
  return tasks;
}

// What the crew found, each under its block; gives the programs' results by their files, to which
// `reports` points.
std::map<std::string, ExampleResult> collect(std::vector<ExampleTask> tasks, Evaluation& evaluation,
                                             Reports& reports) {
  std::map<std::string, ExampleResult> programs;
  for (ExampleTask& task : tasks) {
    evaluation.diagnostics.insert(evaluation.diagnostics.end(), task.diagnostics.begin(),
                                  task.diagnostics.end());
    LessonResults& results = evaluation.lessons[task.lesson];
    if (task.program) results.seconds[task.block] = task.seconds;
    if (task.program && task.results.empty()) reports.add(task.program->name(), nullptr);
    for (auto& [block, result] : task.results) {
      if (task.program) {
        const ExampleResult& kept = programs[task.program->file.text] = result;
        reports.add(task.program->name(), &kept);
      }
      results.of_block[block] = std::move(result);
    }
  }
  return programs;
}

// A region has what its program printed, but not its program's code.
void show_regions(const Lesson& lesson, const std::filesystem::path& root,
                  const ShownPrograms& shown, const std::map<std::string, ExampleResult>& programs,
                  LessonResults& results, Diagnostics& diagnostics) {
  for (std::size_t i = 0; i < lesson.blocks.size(); ++i) {
    const auto* example = std::get_if<Example>(&lesson.blocks[i]);
    if (example == nullptr || !example->region) continue;
    results.of_block.erase(i);
    const std::string& file = example->file.text;
    const Example* whole = shown.at(file).text();
    const auto text = whole != nullptr ? whole->code.text : DiskFiles(root).read(file);
    if (!text) continue;  // reported where the program is run
    const auto program = programs.find(file);
    const bool ran = program != programs.end();
    const bool may_edit = ran && whole == nullptr && !shown.at(file).contradicts_itself();
    const auto code =
        evaluate_region(*example, SourceText(file, *text), may_edit, lesson, diagnostics);
    if (code && ran) results.of_block[i] = ExampleResult{*code, program->second.output};
  }
}

}  // namespace

Evaluation evaluate(const Course& course, const std::filesystem::path& root, const Files& assets,
                    Progress& progress, Diagnostics found) {
  Evaluation evaluation;
  evaluation.lessons.resize(course.lessons.size());
  evaluation.diagnostics = std::move(found);
  evaluation.versions = known_versions(assets);
  std::vector<ExampleTask> tasks = plan_examples(course);
  progress.plan(count_tasks(course) + static_cast<int>(tasks.size()));
  const ShownPrograms shown = shown_programs(course);
  ExampleCrew crew(course, shown, root, progress, std::move(tasks));
  evaluation.versions.compiler = crew.compiler();
  Workshop workshop(course, root, assets);
  evaluation.versions.katex = workshop.typesetter().version();
  std::vector<LessonEvaluator> evaluators;
  for (std::size_t i = 0; i < course.lessons.size(); ++i) {
    evaluators.emplace_back(course.lessons[i], workshop, progress, evaluation.lessons[i],
                            evaluation.diagnostics);
  }
  if (course.glossary) {
    evaluators.emplace_back(course.glossary->page, workshop, progress, evaluation.glossary,
                            evaluation.diagnostics);
  }
  for (LessonEvaluator& evaluator : evaluators) evaluator.run_beside_examples();
  evaluation.models = evaluate_model_pages(workshop, evaluation.diagnostics);
  evaluation.api = evaluate_api(course, DiskFiles(mujoco_headers_folder()), evaluation.diagnostics);
  const auto programs = collect(crew.finish(), evaluation, workshop.reports());
  for (LessonEvaluator& evaluator : evaluators) evaluator.run_after_examples();
  for (std::size_t i = 0; i < course.lessons.size(); ++i) {
    show_regions(course.lessons[i], root, shown, programs, evaluation.lessons[i],
                 evaluation.diagnostics);
    compare_outputs(course.lessons[i], evaluation.lessons[i], evaluation.diagnostics);
  }
  make_claims(course, root, programs, evaluation);
  return evaluation;
}

const LessonResults& Evaluation::results_of(const Course& course, const Lesson& page) const {
  if (course.glossary && &page == &course.glossary->page) return glossary;
  return lessons.at(static_cast<std::size_t>(&page - course.lessons.data()));
}

}  // namespace mjcourse
