// Worker: a process of its own for what an author's scripts and models are worked on with.
//
// A script engine and MuJoCo take what they are given on trust, and whoever sends a change to a
// course writes scripts and models. So a generator does not let them work in its own process, which
// may read the user's files and knows what the environment has. A worker is the same program,
// started with nothing of that and confined as a lesson's programs are; it is asked for one task
// after the other (work_loop.h), and one that ends, or takes too much time or memory, costs the
// task that it was at.
//
// Enter with work(). The process begins with the first task, and there is a new one after each that
// ended.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>

#include "evaluate/setting.h"
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
  std::uint64_t memory = 3ull << 30;  // bytes; a model is tried with two thirds of it
};

class Worker {
 public:
  // The setting must outlive this.
  Worker(const Setting& setting, WorkerProgram program, WorkLimits limits = {});
  ~Worker();
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  // Task::work_apart(): of the task, in the process. Where that came to nothing, the finding has a
  // diagnostic that says so at the task's place. Throws std::runtime_error with what the process
  // threw, and Cancelled.
  bool work(const Task& task, Trace& trace, Finding& finding);

 private:
  class Process;

  const Setting& setting_;
  WorkerProgram program_;
  WorkLimits limits_;
  std::unique_ptr<Process> process_;
};

}  // namespace mjcourse
