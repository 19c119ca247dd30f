// Worker: a process of its own for what an author's scripts and models are worked on with.
//
// A script engine and MuJoCo trust what they are given, and the author of a change to a course may
// be a stranger. So they do not work in the generator's own process, which may read the user's
// files and knows the environment. A worker is the same program, started with nothing of that and
// confined as a lesson's programs are. It is asked for one task after the other (work_loop.h); one
// that ends, or takes too much time or memory, costs the task that it was at.
//
// Enter with work(). The process begins with the first task, and there is a new one after each that
// ended.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>

#include "evaluate/context/run_context.h"
#include "evaluate/task.h"

namespace mjcourse {

// The command that has the program be a worker, before the course's folder and the assets'.
inline constexpr const char* kWorkCommand = "--work";

// The generator's own file, and where its assets are; both absolute.
struct WorkerProgram {
  std::filesystem::path file, assets;
};

// Of one task, whatever it is made of.
struct WorkLimits {
  double seconds = 60;
  // Bytes. A model may take 2 GiB of it, and once more where it is drawn. A machine without so much
  // for each worker gives less (concurrency.h).
  std::uint64_t memory = 5ull << 30;
};

class Worker {
 public:
  // The run context must outlive this.
  Worker(const RunContext& run_context, WorkerProgram program, WorkLimits limits = {});
  ~Worker();
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  // Task::work_apart(): of the task, in the process. Where that came to nothing, the finding has a
  // diagnostic that says so at the task's place. Throws std::runtime_error with what the process
  // threw, and Cancelled.
  bool work(const Task& task, Trace& trace, Finding& finding);

 private:
  class Process;

  const RunContext& run_context_;
  WorkerProgram program_;
  WorkLimits limits_;
  std::unique_ptr<Process> process_;
};

}  // namespace mjcourse
