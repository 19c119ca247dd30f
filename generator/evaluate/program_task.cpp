#include "evaluate/program_task.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "base/cpp_includes.h"
#include "base/stopwatch.h"
#include "evaluate/context/recipe.h"
#include "evaluate/programs/compiled_recipe.h"
#include "evaluate/programs/example.h"
#include "evaluate/programs/exercise.h"
#include "evaluate/programs/page_run.h"
#include "report/refused_file.h"
#include "toolchain/warm_header.h"

namespace mjcourse {

Dependencies ProgramTask::recipe(const RunContext& run_context) const {
  std::vector<std::string> text{program_.file.text,
                                code_->text.text,
                                program_.compiles ? "runs" : "is refused",
                                program_.optimize ? "optimized" : "plain",
                                program_.native,
                                std::to_string(program_.seconds),
                                std::to_string(program_.exit_code)};
  text.insert(text.end(), program_.arguments.begin(), program_.arguments.end());
  Dependencies recipe = compiled_recipe(run_context, "program", text, program_.optimize);
  return mjcourse::draws(code_->text.text) ? with_drawing(std::move(recipe)) : recipe;
}

std::vector<std::string> ProgramTask::warm_roots(const RunContext& run_context) const {
  if (program_.optimize || !code_) return {};
  return mjcourse::warm_roots(code_->text.text, run_context.include_folders());
}

bool ProgramTask::prepare(WorkerContext& worker_context, Finding& finding) {
  const DiskFiles files(worker_context.root());
  const std::string& path = program_.file.text;
  if (const auto refusal = files.refusal(path)) {
    const Place place = place_of(*lesson().source, program_.file.span());
    finding.diagnostics.push_back(refused_file(place, path, *refusal));
    return false;
  }
  file_ = files.read(path);
  code_ = code_of(program_, worker_context.run_context().shown().at(program_.file.text), lesson(),
                  file_, finding.diagnostics);
  return code_.has_value();
}

bool ProgramTask::work(WorkerContext& worker_context, Finding& finding) {
  const Stopwatch stopwatch;
  auto result =
      evaluate_example(program_, code_->text, lesson(), worker_context, finding.diagnostics);
  if (!result) return false;
  const std::vector<Check> checks = result->records.checks;
  report_failing_checks(program_, code_->text, checks, lesson(), finding.diagnostics);
  if (std::ranges::any_of(checks, [](const Check& check) { return !check.holds; })) return false;
  finding.results[block()] = *std::move(result);
  finding.seconds[block()] = stopwatch.seconds();
  return true;
}

// The program is as it should be, so its file may be written from what the lesson shows.
void ProgramTask::conclude(WorkerContext& worker_context, Finding& finding) {
  if (!code_ || !code_->differs || !finding.results.contains(block())) return;
  offer_file(program_, worker_context.run_context().shown().at(program_.file.text), lesson(), file_,
             finding.diagnostics[*code_->differs]);
}

bool ProgramTask::is_compiled(WorkerContext& worker_context) const {
  return code_ && is_known(program_, code_->text, lesson(), worker_context);
}

bool ProgramTask::work_in_page(WorkerContext& worker_context, const Finding* native,
                               Finding& finding) {
  if (!program_.compiles) return true;
  std::optional<ExampleResult> result;
  if (native != nullptr && !is_compiled(worker_context)) {
    // A run that is not kept, as of a program that warns, is held against as it was shown.
    result = std::get<ExampleResult>(native->results.at(block()));
    worker_context.trace().unknown();
  } else {
    Diagnostics known;  // of the native run
    result = evaluate_example(program_, code_->text, lesson(), worker_context, known);
  }
  if (!result) return false;
  if (auto page = run_in_page(program_, code_->text.text, *result, worker_context)) {
    finding.pages[block()] = *std::move(page);
  }
  return true;
}

}  // namespace mjcourse
