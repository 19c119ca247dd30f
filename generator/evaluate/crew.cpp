#include "evaluate/crew.h"

#include <algorithm>
#include <chrono>
#include <optional>

#include "base/cancellation.h"
#include "base/parallel.h"

namespace mjcourse {

void Crew::look(Task& task, Workshop& workshop, TaskRecord& record) const {
  record.looked = true;
  workshop.trace().clear();
  if (!task.prepare(workshop, record.finding)) return;
  record.said = record.finding.diagnostics.size();
  record.recipe = task.recipe(setting_);
  record.waiting = archive_ == nullptr || !archive_->find(task, record, effort_ == Effort::all);
}

void Crew::do_task(Task& task, Workshop& workshop, TaskRecord& record) const {
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
    const bool whole = task.work(workshop, record.finding);
    const bool silent = record.finding.diagnostics.size() == record.said;
    if (archive_ != nullptr && whole && silent) {
      archive_->keep(task, workshop.trace(), begin, record);
    }
  }
  task.conclude(workshop, record.finding);
}

void Crew::look_at_programs(const Tasks& tasks, TaskRecords& records) const {
  std::vector<std::size_t> programs;
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    if (tasks[i]->compiles()) programs.push_back(i);
  }
  const std::stop_token stop = cancellation();
  for_each_index(programs.size(), threads_, [&](std::size_t index, std::size_t) {
    const Cancellable cancellable(stop);
    end_if_cancelled();
    Workshop workshop(setting_);
    look(*tasks[programs[index]], workshop, records[programs[index]]);
  });
}

void Crew::make_headers(SharedHeaders& headers, std::size_t thread, const Stopwatch& stopwatch,
                        TaskQueue& queue) {
  while (const std::optional<SharedHeaders::Header> header = headers.next()) {
    const double begin = stopwatch.seconds();
    progress_.begin(header->what());
    headers.make(*header);
    progress_.end(header->what());
    queue.finish_header();
    const std::lock_guard lock(mutex_);
    header_times_.push_back({header->what(), thread, begin, stopwatch.seconds() - begin});
  }
}

TaskRecords Crew::run(const Tasks& tasks, const Blocks& first,
                      const std::function<void(const TaskRecords&)>& publish) {
  TaskRecords records(tasks.size());
  const Stopwatch stopwatch;
  look_at_programs(tasks, records);
  std::vector<const Task*> waiting;
  for (std::size_t i = 0; i < tasks.size() && effort_ == Effort::all; ++i) {
    if (records[i].looked && records[i].waiting) waiting.push_back(tasks[i].get());
  }
  SharedHeaders headers(setting_, waiting);
  progress_.plan(tasks.size() + headers.size());
  TaskQueue queue(tasks, first, headers.size(), [&] { publish(records); });
  const std::stop_token stop = cancellation();
  const std::size_t threads = std::min(threads_, tasks.size());
  for_each_index(threads, threads, [&](std::size_t thread, std::size_t) {
    const Cancellable cancellable(stop);
    try {
      make_headers(headers, thread, stopwatch, queue);
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
