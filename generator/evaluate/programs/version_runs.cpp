#include "evaluate/programs/version_runs.h"

#include <utility>

#include "evaluate/programs/joined_programs.h"
#include "evaluate/programs/page_run.h"

namespace mjcourse {
namespace {

// What the page's compiler refuses, it may take one by one.
bool is_known_of_page(const ExampleResult& result) {
  return !result.page || !result.page->why_not.starts_with(kPageRefuses);
}

}  // namespace

std::optional<CompiledExample> VersionRuns::join() const {
  if (versions_.size() < 2) return std::nullopt;
  const auto text = joined_programs(versions_, program_.file.text);
  if (!text) return std::nullopt;
  Diagnostics none;  // each version alone says more of what is wrong with it
  auto compiled = compile_example(program_, {*text, {}}, lesson_, worker_context_, none);
  if (!compiled || !compiled->compiled.succeeded) return std::nullopt;
  return compiled;
}

std::optional<ExampleResult> VersionRuns::run_joined(std::size_t index, Diagnostics& diagnostics) {
  if (!std::exchange(was_joined_, true)) joined_ = join();
  if (!joined_) return std::nullopt;
  Example version = program_;
  version.arguments = joined_arguments(index, program_.arguments);
  return run_example(version, *joined_, lesson_, worker_context_, diagnostics);
}

std::optional<ExampleResult> VersionRuns::run(std::size_t index, Diagnostics& diagnostics) {
  Diagnostics found;
  auto result = run_joined(index, found);
  const bool is_told = result ? is_known_of_page(*result) : !found.empty();
  if (!is_told) {
    return evaluate_example(program_, {versions_[index], {}}, lesson_, worker_context_,
                            diagnostics);
  }
  diagnostics.insert(diagnostics.end(), found.begin(), found.end());
  return result;
}

}  // namespace mjcourse
