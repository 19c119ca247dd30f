#include "evaluate/crew.h"

#include <algorithm>
#include <chrono>
#include <optional>

#include "base/cancellation.h"
#include "base/parallel.h"
#include "base/stopwatch.h"
#include "evaluate/task_queue.h"

namespace mjcourse {

void Crew::do_task(Task& task, Workshop& workshop, TaskRecord& record) const {
  workshop.trace().clear();
  if (task.prepare(workshop, record.finding)) {
    const std::size_t said = record.finding.diagnostics.size();
    record.recipe = task.recipe(setting_);
    if (archive_ == nullptr || !archive_->find(task, record, effort_ == Effort::all)) {
      const bool quick = record.recipe.empty();  // as is all that is never kept
      if (effort_ == Effort::looks && !quick) {
        record.open = true;
        return;
      }
      if (!quick) progress_.begin(task.what());
      // From here on a trace tells what the work depends on; what preparing read is in the recipe.
      workshop.trace().clear();
      const auto begin = std::chrono::system_clock::now();
      const bool whole = task.work(workshop, record.finding);
      const bool silent = record.finding.diagnostics.size() == said;
      if (archive_ != nullptr && whole && silent) {
        archive_->keep(task, workshop.trace(), begin, record);
      }
    }
  }
  task.conclude(workshop, record.finding);
}

TaskRecords Crew::run(const Tasks& tasks, const Blocks& first,
                      const std::function<void(const TaskRecords&)>& publish) {
  TaskRecords records(tasks.size());
  TaskQueue queue(tasks, first, [&] { publish(records); });
  progress_.plan(tasks.size());
  const Stopwatch stopwatch;
  const std::stop_token stop = cancellation();
  const std::size_t threads = std::min(threads_, tasks.size());
  for_each_index(threads, threads, [&](std::size_t thread, std::size_t) {
    const Cancellable cancellable(stop);
    try {
      Workshop workshop(setting_);
      while (const std::optional<std::size_t> next = queue.next()) {
        TaskRecord& record = records[*next];
        record.thread = thread;
        record.begin = stopwatch.seconds();
        end_if_cancelled();
        do_task(*tasks[*next], workshop, record);
        progress_.end(tasks[*next]->what());
        record.seconds = stopwatch.seconds() - record.begin;
        queue.finish(*next);
      }
    } catch (...) {
      queue.stop();
      throw;
    }
  });
  return records;
}

}  // namespace mjcourse
