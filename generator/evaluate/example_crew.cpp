#include "evaluate/example_crew.h"

#include <algorithm>
#include <set>
#include <utility>

#include "evaluate/example.h"

namespace mjcourse {
namespace {

template <typename Visit>
void for_each_example(const Course& course, const Visit& visit) {
  for (std::size_t l = 0; l < course.lessons.size(); ++l) {
    for (std::size_t b = 0; b < course.lessons[l].blocks.size(); ++b) {
      const auto* example = std::get_if<Example>(&course.lessons[l].blocks[b]);
      if (example != nullptr) visit(l, b, *example);
    }
  }
}

}  // namespace

std::vector<ExampleTask> plan_examples(const Course& course) {
  std::set<std::string> planned;
  for_each_example(course, [&](std::size_t, std::size_t, const Example& example) {
    if (!example.region) planned.insert(example.file.text);
  });
  std::vector<ExampleTask> tasks;
  for_each_example(course, [&](std::size_t lesson, std::size_t block, const Example& example) {
    if (example.region && !planned.insert(example.file.text).second) return;
    ExampleTask& task = tasks.emplace_back(ExampleTask{lesson, block, example});
    if (example.region) task.program.code = {};  // the file's
  });
  return tasks;
}

ExampleCrew::ExampleCrew(const Course& course, std::filesystem::path root, Progress& progress,
                         std::vector<ExampleTask> tasks)
    : course_(course),
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
    progress_.begin("compile and run " + tasks_[i].program.name());
    evaluate(tasks_[i]);
    progress_.done();
  }
}

void ExampleCrew::evaluate(ExampleTask& task) {
  const Lesson& lesson = course_.lessons[task.lesson];
  if (compiler_) {
    task.result = evaluate_example(task.program, lesson, root_, *compiler_, task.diagnostics);
  } else {
    task.diagnostics.push_back(error_at(place_of(*lesson.source, task.program.span),
                                        "E-example-compiler", "no C++ compiler was found",
                                        "install clang-16"));
  }
}

}  // namespace mjcourse
