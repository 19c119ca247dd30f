#include "evaluate/programs/version_runs.h"

#include <utility>

#include "evaluate/programs/joined_programs.h"
#include "evaluate/programs/page_run.h"

namespace mjcourse {

VersionRuns::VersionRuns(Example program, std::vector<std::string> versions, const Lesson& lesson,
                         WorkerContext& worker_context)
    : program_(std::move(program)),
      versions_(std::move(versions)),
      lesson_(lesson),
      worker_context_(worker_context) {
  if (versions_.size() < 2) return;
  auto text = joined_programs(versions_, program_.file.text);
  if (!text) return;
  text_ = {*std::move(text), {}};
  Diagnostics none;  // each version alone says what is wrong with it
  auto joined = native_program(program_, *text_, lesson_, worker_context_, none);
  if (joined) joined_.emplace(*std::move(joined));
}

Example VersionRuns::version(std::size_t index) const {
  Example version = program_;
  version.arguments = joined_arguments(index, program_.arguments);
  return version;
}

std::optional<NativeRun> VersionRuns::run_joined(std::size_t index) {
  if (!joined_) return std::nullopt;
  if (auto run = known_run(version(index), *joined_)) return run;
  if (!joined_->find_refusal()) {
    const Compiled& compiled = joined_->compile();
    if (compiled.succeeded) return new_run(version(index), *joined_);
    if (compiled.refused()) joined_->refusal();  // so that nobody compiles it again
  }
  joined_.reset();
  return std::nullopt;
}

bool VersionRuns::is_known() const {
  if (joined_ && known_run(version(0), *joined_)) return true;
  return mjcourse::is_known(program_, {versions_[0], {}}, lesson_, worker_context_);
}

std::optional<ExampleResult> VersionRuns::run(std::size_t index, Diagnostics& diagnostics) {
  auto run = run_joined(index);
  if (run) return judge_native(program_, *text_, *std::move(run), lesson_, diagnostics);
  return evaluate_example(program_, {versions_[index], {}}, lesson_, worker_context_, diagnostics);
}

std::optional<PageRun> VersionRuns::run_in_page(std::size_t index, const ExampleResult& native) {
  if (joined_) {
    auto page = mjcourse::run_in_page(version(index), text_->text, native, worker_context_);
    // What the page's compiler refuses, it may take one by one.
    if (!page || !page->why_not.starts_with(kPageRefuses)) return page;
  }
  return mjcourse::run_in_page(program_, versions_[index], native, worker_context_);
}

}  // namespace mjcourse
