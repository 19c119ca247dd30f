#include "evaluate/snippets_task.h"

#include <algorithm>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "evaluate/programs/compiled_recipe.h"
#include "evaluate/programs/page_run.h"
#include "evaluate/programs/snippets.h"
#include "findings/snippet_program.h"
#include "toolchain/warm_header.h"

namespace mjcourse {

std::vector<std::size_t> SnippetsTask::blocks() const {
  return blocks_of<Snippet>(lesson());
}

Dependencies SnippetsTask::recipe(const RunContext& run_context) const {
  std::vector<std::string> text{lesson().number};
  for (std::size_t i = block(); i < lesson().blocks.size(); ++i) {
    const auto* snippet = std::get_if<Snippet>(&lesson().blocks[i]);
    if (snippet == nullptr) continue;
    // The place among the blocks is a part of the finding.
    text.insert(text.end(), {std::to_string(i - block()), snippet->model.text, snippet->code.text,
                             snippet->shown, std::to_string(snippet->seconds), snippet->native});
  }
  return compiled_recipe(run_context, "snippets", text, false);
}

std::vector<std::string> SnippetsTask::warm_roots(const RunContext& run_context) const {
  const IncludeFolders include = run_context.include_folders();
  return mjcourse::warm_roots(snippets_prelude(include), include);
}

bool SnippetsTask::work_apart(WorkerContext& worker_context, Finding& finding) {
  for (const Block& block : lesson().blocks) {
    if (const auto* snippet = std::get_if<Snippet>(&block)) {
      worker_context.simulate_named(snippet->model, *lesson().source, finding.diagnostics);
    }
  }
  return true;
}

bool SnippetsTask::work(WorkerContext& worker_context, Finding& finding) {
  for (auto& [index, result] : evaluate_snippets(lesson(), worker_context, finding.diagnostics)) {
    finding.results[index] = std::move(result);
  }
  return finding.results.size() == blocks().size();
}

bool SnippetsTask::is_compiled(WorkerContext& worker_context) const {
  return are_known(lesson(), worker_context);
}

bool SnippetsTask::work_in_page(WorkerContext& worker_context, const Finding*, Finding& finding) {
  Diagnostics known;  // of the native runs
  for (const auto& [index, native] : evaluate_snippets(lesson(), worker_context, known)) {
    auto page = run_in_page(snippet_program(lesson(), index), native.code, native, worker_context);
    if (page) finding.pages[index] = *std::move(page);
  }
  return finding.pages.size() == blocks().size();
}

}  // namespace mjcourse
