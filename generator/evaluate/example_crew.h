// ExampleCrew: runs the programs of all lessons, on as many threads as there are cores.
#pragma once

#include <atomic>
#include <filesystem>
#include <optional>
#include <thread>
#include <vector>

#include "evaluate/compiler.h"
#include "evaluate/evaluate.h"

namespace mjcourse {

// A program to run, and what came of it.
struct ExampleTask {
  std::size_t lesson, block;
  Example program;  // all of it, also where the block shows a region
  std::optional<ExampleResult> result = {};
  Diagnostics diagnostics = {};
};

// One task for each program that is shown whole, and one for each that is shown in regions alone.
std::vector<ExampleTask> plan_examples(const Course& course);

class ExampleCrew {
 public:
  // Begins at once.
  ExampleCrew(const Course& course, std::filesystem::path root, Progress& progress,
              std::vector<ExampleTask> tasks);

  std::vector<ExampleTask> finish();

 private:
  void work();
  void evaluate(ExampleTask& task);

  const Course& course_;
  std::filesystem::path root_;
  Progress& progress_;
  std::vector<ExampleTask> tasks_;
  std::optional<Compiler> compiler_;
  std::atomic<std::size_t> next_ = 0;
  std::vector<std::jthread> threads_;
};

}  // namespace mjcourse
