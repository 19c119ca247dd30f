// TaskQueue: which task is next.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <functional>
#include <mutex>
#include <optional>
#include <vector>

#include "evaluate/plan.h"
#include "findings/lesson_results.h"

namespace mjcourse {

// From any thread. Those of the blocks `first` come before all others, and then the one with the
// most effort; those that quote are held back until all programs are finished. As long as there is
// anything else to do, one thread draws and the others do not, and it is always the same: its
// worker has compiled shaders and models that another would compile once more. What compiles is
// held back until it is known how much of it there is, and while a header is made that would have
// it compiled sooner, it comes last.
class TaskQueue {
 public:
  // `publish` is called once, on one of the threads, before the first task that quotes is given.
  TaskQueue(const Tasks& tasks, const Blocks& first, std::function<void()> publish);

  // What compiles may be given, where there is nothing else.
  void programs_known();
  // What compiles is like all else.
  void headers_made();

  // For one of the threads. Waits where there is none yet; nothing where there is none any more.
  std::optional<std::size_t> next(std::size_t thread = 0);
  void finish(std::size_t task);
  // Something went wrong: nobody gets another.
  void stop();

 private:
  struct Weight {
    bool first = false;
    double effort = 0;
    auto operator<=>(const Weight&) const = default;
  };
  // The next one last.
  struct Ready {
    std::vector<std::size_t> drawn, compiled, others;
    bool empty() const { return drawn.empty() && compiled.empty() && others.empty(); }
  };

  std::vector<std::size_t>& list_of(Ready& tasks, std::size_t task) const;
  // The list whose last task is next; null where none is to be had now.
  std::vector<std::size_t>* next_list(std::size_t thread);
  void release();

  const Tasks& tasks_;
  std::function<void()> publish_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<Weight> weights_;
  Ready ready_, held_;
  std::size_t programs_ = 0;           // not finished
  std::optional<std::size_t> drawer_;  // the thread that draws
  enum class Programs { held, last, usual } compiling_ = Programs::held;
};

}  // namespace mjcourse
