#include "evaluate/evaluate.h"

#include <mujoco/mujoco.h>

#include <algorithm>
#include <atomic>
#include <optional>
#include <thread>
#include <utility>

#include "evaluate/compiler.h"
#include "evaluate/example.h"
#include "evaluate/formula.h"
#include "evaluate/inline_value.h"
#include "evaluate/lab.h"
#include "evaluate/output.h"
#include "evaluate/question.h"
#include "evaluate/workshop.h"

namespace mjcourse {
namespace {

// An example of some lesson, and what came of it.
struct Task {
  std::size_t lesson, block;
  std::optional<ExampleResult> result = {};
  Diagnostics diagnostics = {};
};

std::vector<Task> plan_examples(const Course& course) {
  std::vector<Task> tasks;
  for (std::size_t l = 0; l < course.lessons.size(); ++l) {
    for (std::size_t b = 0; b < course.lessons[l].blocks.size(); ++b) {
      if (std::holds_alternative<Example>(course.lessons[l].blocks[b])) tasks.push_back({l, b});
    }
  }
  return tasks;
}

// Runs all tasks on as many threads as there are cores.
class ExampleCrew {
 public:
  ExampleCrew(const Course& course, std::filesystem::path root, Progress& progress)
      : course_(course),
        root_(std::move(root)),
        progress_(progress),
        tasks_(plan_examples(course)),
        compiler_(tasks_.empty() ? std::nullopt : Compiler::find()) {
    const std::size_t cores = std::max(1u, std::thread::hardware_concurrency());
    for (std::size_t i = 0; i < std::min(cores, tasks_.size()); ++i) {
      threads_.emplace_back([this] { work(); });
    }
  }

  std::vector<Task> finish() {
    for (std::jthread& thread : threads_) thread.join();
    return std::move(tasks_);
  }
  std::size_t size() const { return tasks_.size(); }

 private:
  void work() {
    for (std::size_t i = next_++; i < tasks_.size(); i = next_++) {
      Task& task = tasks_[i];
      const Lesson& lesson = course_.lessons[task.lesson];
      const Example& example = std::get<Example>(lesson.blocks[task.block]);
      progress_.begin("compile and run " + example.name());
      if (compiler_) {
        task.result = evaluate_example(example, lesson, root_, *compiler_, task.diagnostics);
      } else {
        task.diagnostics.push_back(error_at(place_of(*lesson.source, example.span),
                                            "E-example-compiler", "no C++ compiler was found",
                                            "install clang-16"));
      }
      progress_.done();
    }
  }

  const Course& course_;
  std::filesystem::path root_;
  Progress& progress_;
  std::vector<Task> tasks_;
  std::optional<Compiler> compiler_;
  std::atomic<std::size_t> next_ = 0;
  std::vector<std::jthread> threads_;
};

// What one lesson's formulas, labs, questions and inline values come to.
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
      const bool quotes =
          std::holds_alternative<InlineValue>(block) || std::holds_alternative<Quiz>(block);
      if (quotes != quoting) continue;
      std::visit([&](const auto& known) { evaluate_block(i, known); }, block);
    }
  }

  void evaluate_block(std::size_t index, const InlineValue& value) {
    auto result = evaluate_value(value, lesson_, workshop_, diagnostics_);
    if (!result) return;
    results_.of_block[index] = *std::move(result);
    ++results_.tally.values;
  }
  void evaluate_block(std::size_t index, const Math& math) {
    auto result = evaluate_formula(math, lesson_, workshop_, diagnostics_);
    if (!result) return;
    results_.of_block[index] = *std::move(result);
    ++results_.tally.formulas;
  }
  void evaluate_block(std::size_t index, const Lab& lab) {
    progress_.begin("rehearse the lab \"" + lab.title + "\"");
    if (auto result = evaluate_lab(lab, lesson_, workshop_, diagnostics_)) {
      ++results_.tally.labs;
      if (result->poster) ++results_.tally.pictures;
      results_.of_block[index] = *std::move(result);
    }
    progress_.done();
  }
  void evaluate_block(std::size_t index, const Quiz& quiz) {
    progress_.begin("prove the answers of " + quiz.id);
    QuizResult result;
    for (const Question& question : quiz.questions) {
      const auto answer = evaluate_question(question, lesson_, workshop_, diagnostics_);
      if (answer)
        ++(answer->proved ? results_.tally.answers_proved : results_.tally.answers_asserted);
      result.questions.push_back(answer.value_or(QuestionResult{}));
    }
    results_.of_block[index] = std::move(result);
    progress_.done();
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
      ++results.tally.outputs;
    }
  }
}

int count_tasks(const Course& course) {
  int tasks = 0;
  for (const Lesson& lesson : course.lessons) {
    for (const Block& block : lesson.blocks) {
      if (std::holds_alternative<Example>(block) || std::holds_alternative<Lab>(block) ||
          std::holds_alternative<Quiz>(block)) {
        ++tasks;
      }
    }
  }
  return tasks;
}

}  // namespace

Evaluation evaluate(const Course& course, const std::filesystem::path& root, const Files& assets,
                    Progress& progress) {
  Evaluation evaluation;
  evaluation.lessons.resize(course.lessons.size());
  evaluation.mujoco = mj_versionString();
  progress.plan(count_tasks(course));
  ExampleCrew crew(course, root, progress);
  Workshop workshop(course, root, assets);
  std::vector<LessonEvaluator> evaluators;
  for (std::size_t i = 0; i < course.lessons.size(); ++i) {
    evaluators.emplace_back(course.lessons[i], workshop, progress, evaluation.lessons[i],
                            evaluation.diagnostics);
  }
  for (LessonEvaluator& evaluator : evaluators) evaluator.run_beside_examples();
  for (Task& task : crew.finish()) {
    LessonResults& results = evaluation.lessons[task.lesson];
    const auto& example = std::get<Example>(course.lessons[task.lesson].blocks[task.block]);
    if (task.result) {
      results.of_block[task.block] = *std::move(task.result);
      ++results.tally.programs;
    }
    workshop.reports().add(example.name(), results.get<ExampleResult>(task.block));
    evaluation.diagnostics.insert(evaluation.diagnostics.end(), task.diagnostics.begin(),
                                  task.diagnostics.end());
  }
  for (LessonEvaluator& evaluator : evaluators) evaluator.run_after_examples();
  for (std::size_t i = 0; i < course.lessons.size(); ++i) {
    compare_outputs(course.lessons[i], evaluation.lessons[i], evaluation.diagnostics);
  }
  return evaluation;
}

}  // namespace mjcourse
