#include "evaluate/scheduler.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "base/cancellation.h"
#include "base/parallel.h"
#include "evaluate/concurrency.h"
#include "evaluate/program_task.h"
#include "evaluate/shared_headers.h"
#include "process/machine_memory.h"
#include "script/script_bundles.h"

namespace mjcourse {
namespace {

// An exception that nobody foresaw ends one task, and not the check of all others.
TaskRecord failure(const Task& task, const std::exception& error) {
  TaskRecord record;
  record.looked = true;
  record.finding.diagnostics.push_back(error_at(
      task.place(), "E-internal", "mjcourse itself failed at this: " + std::string(error.what()),
      "is there enough memory and disk space? If so, report it with this block; everything else "
      "was checked"));
  return record;
}

}  // namespace

void Scheduler::look(Task& task, WorkerContext& worker_context, TaskRecord& record) const {
  record.looked = true;
  worker_context.trace().clear();
  if (!task.prepare(worker_context, record.finding)) return;
  record.said = record.finding.diagnostics.size();
  record.recipe = task.recipe(run_context_);
  record.waiting = task_store_ == nullptr || !task_store_->find(task, record, is_worked_on(task));
}

void Scheduler::try_to_look(Task& task, WorkerContext& worker_context, TaskRecord& record) const {
  try {
    look(task, worker_context, record);
  } catch (const MissingAssets&) {
    throw;
  } catch (const std::exception&) {
    record = {};  // it will be looked up again, and say why
  }
}

bool Scheduler::is_worked_on(const Task& task) const {
  return effort_ == Effort::all || (effort_ == Effort::natively && !task.is_in_page());
}

bool Scheduler::work(Task& task, Tools& tools, TaskRecord& record) const {
  WorkerContext& worker_context = *tools.worker_context;
  const bool whole = task.is_apart() && tools.worker
                         ? tools.worker->work(task, worker_context.trace(), record.finding)
                         : task.work_apart(worker_context, record.finding);
  return task.work(worker_context, record.finding) && whole;
}

void Scheduler::do_task(Task& task, Tools& tools, TaskRecord& record) const {
  WorkerContext& worker_context = *tools.worker_context;
  if (!record.looked) look(task, worker_context, record);
  if (record.waiting) {
    const bool quick = record.recipe.empty();  // as is all that is never kept
    if (!quick && !is_worked_on(task)) {
      record.open = true;
      return;
    }
    if (!quick) progress_.begin(task.what());
    // From here on a trace tells what the work depends on; what preparing read is in the recipe.
    worker_context.trace().clear();
    const auto begin = std::chrono::system_clock::now();
    const double in_page = worker_context.page_seconds();
    const Stopwatch stopwatch;
    const bool whole = work(task, tools, record);
    record.finding.work = stopwatch.seconds();
    record.in_page = worker_context.page_seconds() - in_page;
    const bool silent = record.finding.diagnostics.size() == record.said;
    if (task_store_ != nullptr && whole && silent) {
      task_store_->keep(task, worker_context.trace(), begin, record);
    }
  }
  task.conclude(worker_context, record.finding);
}

void Scheduler::attempt(Task& task, Tools& tools, TaskRecord& record) const {
  try {
    do_task(task, tools, record);
  } catch (const MissingAssets&) {
    throw;  // no task could do without
  } catch (const std::exception& error) {
    record = failure(task, error);
    tools.worker_context.emplace(run_context_);  // it may have left anything there
  }
}

// A program's page task gets the native finding of the program. All programs are done by now, but
// not all exercises and snippets. An open record has no finding.
void Scheduler::tell_natives(const Tasks& tasks, const TaskRecords& records) const {
  std::map<std::string, const TaskRecord*> by_name;
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    const bool is_done = dynamic_cast<const ProgramTask*>(tasks[i].get()) && !records[i].open;
    if (is_done) by_name[tasks[i]->name_in_course()] = &records[i];
  }
  for (const auto& task : tasks) {
    if (!task->is_in_page()) continue;
    const auto native = by_name.find(task->native_name());
    if (native != by_name.end()) task->take_native(native->second->finding);
  }
}

// What each thread would wait for one after the other, many wait for at once.
void Scheduler::look_at_once(const Tasks& tasks, bool quoting, TaskRecords& records) const {
  const std::size_t askers = task_store_ == nullptr ? 1 : task_store_->at_once();
  if (askers == 1) return;
  std::vector<std::optional<WorkerContext>> contexts(askers);
  const std::stop_token stop = cancellation();
  for_each_index(tasks.size(), askers, [&](std::size_t i, std::size_t asker) {
    if (tasks[i]->waits_for_programs() != quoting) return;
    const Cancellable cancellable(stop);
    end_if_cancelled();
    if (!contexts[asker]) contexts[asker].emplace(run_context_);
    try_to_look(*tasks[i], *contexts[asker], records[i]);
  });
}

// Look up all that compiles, and make what is worth sharing among those that are still to be.
void Scheduler::prepare_programs(const Tasks& tasks, WorkerContext& worker_context,
                                 TaskRecords& records, TaskQueue& queue,
                                 const Stopwatch& stopwatch) {
  std::vector<const Task*> waiting;
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    if (!tasks[i]->compiles()) continue;
    end_if_cancelled();
    if (!records[i].looked) try_to_look(*tasks[i], worker_context, records[i]);
    if (!records[i].waiting) continue;
    worker_context.trace().clear();
    if (!tasks[i]->is_compiled(worker_context)) waiting.push_back(tasks[i].get());
  }
  queue.programs_known();
  if (effort_ == Effort::looks) waiting.clear();
  const std::vector<SharedHeader> headers = shared_headers(run_context_, waiting);
  progress_.plan(tasks.size() + headers.size());
  for (const SharedHeader& header : headers) {
    const double begin = stopwatch.seconds();
    progress_.begin(header.what());
    run_context_.compiler()->make_header(header.roots, header.warmth);
    progress_.end(header.what());
    header_times_.push_back({header.what(), 0, begin, stopwatch.seconds() - begin});
  }
  queue.headers_made();
}

TaskRecords Scheduler::run(const Tasks& tasks, const Blocks& first,
                           const std::function<void(const TaskRecords&)>& publish) {
  TaskRecords records(tasks.size());
  TaskQueue queue(tasks, first, [&] {
    publish(records);
    tell_natives(tasks, records);
    look_at_once(tasks, true, records);
  });
  progress_.plan(tasks.size());
  const Stopwatch stopwatch;
  look_at_once(tasks, false, records);
  const std::stop_token stop = cancellation();
  const auto [threads, limits] = concurrency_of(std::min(threads_, tasks.size()), machine_memory());
  for_each_index(threads, threads, [&, limits = limits](std::size_t thread, std::size_t) {
    const Cancellable cancellable(stop);
    try {
      Tools tools;
      tools.worker_context.emplace(run_context_);
      if (worker_) tools.worker.emplace(run_context_, *worker_, limits);
      if (thread == 0) prepare_programs(tasks, *tools.worker_context, records, queue, stopwatch);
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
