#include "evaluate/evaluate.h"

#include <map>
#include <optional>
#include <utility>

#include "evaluate/claims.h"
#include "evaluate/example_crew.h"
#include "evaluate/lesson_evaluator.h"
#include "evaluate/output.h"
#include "evaluate/region.h"
#include "evaluate/shown_program.h"
#include "evaluate/workshop.h"
#include "physics/mujoco_api.h"

namespace mjcourse {
namespace {

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
