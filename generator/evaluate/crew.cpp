#include "evaluate/crew.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <optional>
#include <string>
#include <utility>

#include "base/cancellation.h"
#include "base/parallel.h"
#include "evaluate/crew_size.h"
#include "evaluate/shared_headers.h"
#include "process/machine_memory.h"
#include "script/known_scripts.h"

namespace mjcourse {
namespace {

// What nobody foresaw ends one task, and not the check of all others.
TaskRecord failure(const Task& task, const std::exception& error) {
  TaskRecord record;
  record.looked = true;
  record.finding.diagnostics.push_back(error_at(
      task.place(), "E-internal", "mjcourse itself failed at this: " + std::string(error.what()),
      "is there memory, and room on the disk? Else report it with this block; everything else was "
      "checked"));
  return record;
}

}  // namespace

void Crew::look(Task& task, Workshop& workshop, TaskRecord& record) const {
  record.looked = true;
  workshop.trace().clear();
  if (!task.prepare(workshop, record.finding)) return;
  record.said = record.finding.diagnostics.size();
  record.recipe = task.recipe(setting_);
  record.waiting = archive_ == nullptr || !archive_->find(task, record, effort_ == Effort::all);
}

bool Crew::work(Task& task, Tools& tools, TaskRecord& record) const {
  Workshop& workshop = *tools.workshop;
  const bool whole = task.is_apart() && tools.worker
                         ? tools.worker->work(task, workshop.trace(), record.finding)
                         : task.work_apart(workshop, record.finding);
  return task.work(workshop, record.finding) && whole;
}

void Crew::do_task(Task& task, Tools& tools, TaskRecord& record) const {
  Workshop& workshop = *tools.workshop;
  if (!record.looked) look(task, workshop, record);
  if (record.waiting) {
    const bool quick = record.recipe.empty();  // as is all that is never kept
    if (effort_ == Effort::looks && !quick) {
      record.open = true;
      return;
    }
    if (!quick) progress_.begin(task.what());
    // From here on a trace tells what the work depends on; what preparing read is in the recipe.
    workshop.trace().clear();
    const auto begin = std::chrono::system_clock::now();
    const bool whole = work(task, tools, record);
    const bool silent = record.finding.diagnostics.size() == record.said;
    if (archive_ != nullptr && whole && silent) {
      archive_->keep(task, workshop.trace(), begin, record);
    }
  }
  task.conclude(workshop, record.finding);
}

void Crew::attempt(Task& task, Tools& tools, TaskRecord& record) const {
  try {
    do_task(task, tools, record);
  } catch (const MissingAssets&) {
    throw;  // no task could do without
  } catch (const std::exception& error) {
    record = failure(task, error);
    tools.workshop.emplace(setting_);  // it may have left anything there
  }
}

// Look up all that compiles, and make what is worth sharing among those that are still to be.
void Crew::prepare_programs(const Tasks& tasks, Workshop& workshop, TaskRecords& records,
                            TaskQueue& queue, const Stopwatch& stopwatch) {
  std::vector<const Task*> waiting;
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    if (!tasks[i]->compiles()) continue;
    end_if_cancelled();
    try {
      look(*tasks[i], workshop, records[i]);
    } catch (const std::exception&) {
      records[i] = {};  // it will be looked up again, and say why
    }
    if (records[i].waiting) waiting.push_back(tasks[i].get());
  }
  queue.programs_known();
  if (effort_ == Effort::looks) waiting.clear();
  const std::vector<SharedHeader> headers = shared_headers(setting_, waiting);
  progress_.plan(tasks.size() + headers.size());
  for (const SharedHeader& header : headers) {
    const double begin = stopwatch.seconds();
    progress_.begin(header.what());
    setting_.compiler()->make_header(header.roots, header.warmth);
    progress_.end(header.what());
    header_times_.push_back({header.what(), 0, begin, stopwatch.seconds() - begin});
  }
  queue.headers_made();
}

TaskRecords Crew::run(const Tasks& tasks, const Blocks& first,
                      const std::function<void(const TaskRecords&)>& publish) {
  TaskRecords records(tasks.size());
  TaskQueue queue(tasks, first, [&] { publish(records); });
  progress_.plan(tasks.size());
  const Stopwatch stopwatch;
  const std::stop_token stop = cancellation();
  const auto [threads, limits] = crew_size(std::min(threads_, tasks.size()), machine_memory());
  for_each_index(threads, threads, [&, limits = limits](std::size_t thread, std::size_t) {
    const Cancellable cancellable(stop);
    try {
      Tools tools;
      tools.workshop.emplace(setting_);
      if (worker_) tools.worker.emplace(setting_, *worker_, limits);
      if (thread == 0) prepare_programs(tasks, *tools.workshop, records, queue, stopwatch);
      while (const std::optional<std::size_t> next = queue.next(thread)) {
        TaskRecord& record = records[*next];
        const double begin = stopwatch.seconds();
        end_if_cancelled();
        attempt(*tasks[*next], tools, record);
        progress_.end(tasks[*next]->what());
        record.thread = thread;
        record.begin = begin;
        record.seconds = stopwatch.seconds() - begin;
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
