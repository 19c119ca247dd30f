#include "evaluate/example_crew.h"

#include <algorithm>
#include <set>
#include <utility>

#include "base/stopwatch.h"
#include "evaluate/example.h"
#include "evaluate/snippets.h"

namespace mjcourse {
namespace {

// The files of the programs that are shown whole.
std::set<std::string> whole_programs(const Course& course) {
  std::set<std::string> files;
  for (const Lesson& lesson : course.lessons) {
    for (const Block& block : lesson.blocks) {
      const auto* example = std::get_if<Example>(&block);
      if (example != nullptr && !example->region) files.insert(example->file.text);
    }
  }
  return files;
}

}  // namespace

std::vector<ExampleTask> plan_examples(const Course& course) {
  std::set<std::string> planned = whole_programs(course);
  std::vector<ExampleTask> tasks;
  for (std::size_t l = 0; l < course.lessons.size(); ++l) {
    const std::vector<Block>& blocks = course.lessons[l].blocks;
    bool has_snippets = false;
    for (std::size_t b = 0; b < blocks.size(); ++b) {
      if (const auto* example = std::get_if<Example>(&blocks[b])) {
        if (example->region && !planned.insert(example->file.text).second) continue;
        tasks.push_back({l, b, *example, example->span});
        if (example->region) tasks.back().program->code = {};  // the file's
      } else if (const auto* snippet = std::get_if<Snippet>(&blocks[b]); snippet && !has_snippets) {
        has_snippets = true;
        tasks.push_back({l, b, std::nullopt, snippet->span});
      }
    }
  }
  return tasks;
}

ExampleCrew::ExampleCrew(const Course& course, const ShownPrograms& shown,
                         std::filesystem::path root, Progress& progress,
                         std::vector<ExampleTask> tasks)
    : course_(course),
      shown_(shown),
      root_(std::move(root)),
      progress_(progress),
      tasks_(std::move(tasks)),
      compiler_(tasks_.empty() ? std::nullopt : Compiler::find()) {
  const std::size_t cores = std::max(1u, std::thread::hardware_concurrency());
  for (std::size_t i = 0; i < std::min(cores, tasks_.size()); ++i) {
    threads_.emplace_back([this] { work(); });
  }
}

std::vector<ExampleTask> ExampleCrew::finish() {
  for (std::jthread& thread : threads_) thread.join();
  return std::move(tasks_);
}

void ExampleCrew::work() {
  for (std::size_t i = next_++; i < tasks_.size(); i = next_++) {
    const ExampleTask& task = tasks_[i];
    progress_.begin("compile and run " +
                    (task.program ? task.program->name()
                                  : "the snippets of " + course_.lessons[task.lesson].number));
    const Stopwatch stopwatch;
    evaluate(tasks_[i]);
    tasks_[i].seconds = stopwatch.seconds();
    progress_.done();
  }
}

void ExampleCrew::evaluate(ExampleTask& task) {
  const Lesson& lesson = course_.lessons[task.lesson];
  if (!compiler_) {
    task.diagnostics.push_back(error_at(place_of(*lesson.source, task.span), "E-example-compiler",
                                        "no C++ compiler was found", "install clang-16"));
  } else if (!task.program) {
    task.results = evaluate_snippets(lesson, course_, root_, *compiler_, task.diagnostics);
  } else if (auto result = evaluate_example(*task.program, shown_.at(task.program->file.text),
                                            lesson, root_, *compiler_, task.diagnostics)) {
    task.results[task.block] = *std::move(result);
  }
}

}  // namespace mjcourse
