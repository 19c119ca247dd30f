// PageTask: what the programs of another task are in the page.
//
// They are compiled and run once more, as a reader's page does it, after all programs have run
// natively. What that gave is found again (actions/action_store.h), or done here where another
// machine has the other task.
// Tested by tests/generator/evaluate/programs/page_run_test.cpp.
#pragma once

#include <memory>
#include <optional>
#include <utility>

#include "evaluate/task.h"

namespace mjcourse {

class PageTask : public Task {
 public:
  // The task is one of its own, and not the one that runs natively.
  explicit PageTask(std::unique_ptr<Task> native)
      : Task(native->lesson(), native->page(), native->block(), native->what() + " in the page"),
        native_(std::move(native)) {}

  const Task& native() const { return *native_; }
  // What an earlier result of its block says of the page.
  std::optional<PageRun> known_of(const Result& result) const;

  std::vector<std::size_t> blocks() const override { return native_->blocks(); }
  bool waits_for_programs() const override { return true; }
  bool is_in_page() const override { return true; }
  double effort() const override { return 2 * native_->effort(); }
  Dependencies recipe(const RunContext& run_context) const override;
  std::string native_name() const override { return native_->name_in_course(); }
  void take_native(const Finding& finding) override { native_finding_ = &finding; }
  bool prepare(WorkerContext& worker_context, Finding& finding) override;
  bool work(WorkerContext& worker_context, Finding& finding) override;
  void conclude(WorkerContext& worker_context, Finding& finding) override;

 private:
  std::unique_ptr<Task> native_;
  const Finding* native_finding_ = nullptr;
};

}  // namespace mjcourse
