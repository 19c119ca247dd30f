// ExampleCrew: runs the programs and the snippets of all lessons, on as many threads as there are
// cores.
#pragma once

#include <atomic>
#include <filesystem>
#include <map>
#include <optional>
#include <thread>
#include <vector>

#include "evaluate/compiler.h"
#include "evaluate/evaluate.h"
#include "evaluate/shown_program.h"

namespace mjcourse {

// A program to run, or all snippets of a lesson, and what came of it.
struct ExampleTask {
  std::size_t lesson, block;       // the snippets' first one
  std::optional<Example> program;  // all of it, also where the block shows a region
  Span span;                       // of the fence
  std::map<std::size_t, ExampleResult> results = {};  // by block
  Diagnostics diagnostics = {};
  double seconds = 0;  // measured
};

// One task for each program that is shown whole, and one for each that is shown in regions alone;
// one for each lesson that has snippets.
std::vector<ExampleTask> plan_examples(const Course& course);

class ExampleCrew {
 public:
  // Begins at once.
  ExampleCrew(const Course& course, const ShownPrograms& shown, std::filesystem::path root,
              Progress& progress, std::vector<ExampleTask> tasks);

  // "clang 16.0.6"; empty when there is none, or nothing to compile.
  std::string compiler() const { return compiler_ ? compiler_->version() : ""; }

  std::vector<ExampleTask> finish();

 private:
  void work();
  void evaluate(ExampleTask& task);

  const Course& course_;
  const ShownPrograms& shown_;
  std::filesystem::path root_;
  Progress& progress_;
  std::vector<ExampleTask> tasks_;
  std::optional<Compiler> compiler_;
  std::atomic<std::size_t> next_ = 0;
  std::vector<std::jthread> threads_;
};

}  // namespace mjcourse
