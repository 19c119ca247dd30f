// Scheduler: runs the tasks of a course on several threads.
//
// Steps of a task: it is prepared; its finding is looked up among those that were kept, or else
// worked out, and kept if it is whole and came without a word; it is concluded. One thread first
// looks up all that compiles, so that it is known which programs are to come, and makes what they
// share (shared_headers.h). The task with the most work begins first; those that quote programs
// wait until all programs have been run. A store behind a net is asked for all of them at once. A
// scheduler that only looks does not work: what was not kept stays open, and with it all that
// quotes. What always holds: findings do not depend on the number of threads, nor on which of them
// were kept.
#pragma once

#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "base/stopwatch.h"
#include "evaluate/plan.h"
#include "evaluate/progress.h"
#include "evaluate/task_queue.h"
#include "evaluate/task_store.h"
#include "evaluate/worker.h"
#include "findings/evaluation.h"

namespace mjcourse {

// What is worked on: all, all but what programs are in the page, or nothing.
enum class Effort { all, natively, looks };

using TaskRecords = std::vector<TaskRecord>;  // one for each task, in their order

class Scheduler {
 public:
  // `task_store` may be null. All must outlive this. Without a `worker`, all tasks run in this
  // process.
  Scheduler(const RunContext& run_context, TaskStore* task_store, Progress& progress,
            std::size_t threads, Effort effort = Effort::all,
            std::optional<WorkerProgram> worker = {})
      : run_context_(run_context),
        task_store_(task_store),
        progress_(progress),
        threads_(threads),
        effort_(effort),
        worker_(std::move(worker)) {}

  // After run(): how long it took to make what programs share.
  const std::vector<TaskTime>& header_times() const { return header_times_; }

  // `publish` is called once, when all that quotes nothing has been begun and all programs are
  // done, and before any that quotes begins. What a task throws is told at its block. Throws
  // MissingAssets, and Cancelled where the caller's work is cancelled (base/cancellation.h).
  // The blocks `first` come first.
  TaskRecords run(const Tasks& tasks, const Blocks& first,
                  const std::function<void(const TaskRecords&)>& publish);

 private:
  // What one thread works with.
  struct Tools {
    std::optional<WorkerContext> worker_context;
    std::optional<Worker> worker;
  };

  void look(Task& task, WorkerContext& worker_context, TaskRecord& record) const;
  // Where it throws, the record is as before.
  void try_to_look(Task& task, WorkerContext& worker_context, TaskRecord& record) const;
  void look_at_once(const Tasks& tasks, bool quoting, TaskRecords& records) const;
  bool is_worked_on(const Task& task) const;
  bool work(Task& task, Tools& tools, TaskRecord& record) const;
  void do_task(Task& task, Tools& tools, TaskRecord& record) const;
  void tell_natives(const Tasks& tasks, const TaskRecords& records) const;
  void attempt(Task& task, Tools& tools, TaskRecord& record) const;
  void prepare_programs(const Tasks& tasks, WorkerContext& worker_context, TaskRecords& records,
                        TaskQueue& queue, const Stopwatch& stopwatch);

  const RunContext& run_context_;
  TaskStore* task_store_;
  Progress& progress_;
  std::size_t threads_;
  Effort effort_;
  std::optional<WorkerProgram> worker_;
  std::vector<TaskTime> header_times_;
};

}  // namespace mjcourse
