#include "base/parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace mjcourse {
namespace {

// The indices that are left, and the exception of the lowest index that threw one.
class Indices {
 public:
  explicit Indices(std::size_t count) : end_(count) {}

  void work_off(std::size_t thread,
                const std::function<void(std::size_t index, std::size_t thread)>& work) {
    // Behind an index that failed nothing is begun; before it, all is: so which one is lowest does
    // not depend on the threads.
    for (std::size_t index = next_++; index < end_; index = next_++) {
      try {
        work(index, thread);
      } catch (...) {
        keep(index, std::current_exception());
      }
    }
  }

  void rethrow() const {
    if (exception_) std::rethrow_exception(exception_);
  }

 private:
  void keep(std::size_t index, std::exception_ptr exception) {
    const std::lock_guard lock(mutex_);
    if (index >= end_) return;
    end_ = index;
    exception_ = std::move(exception);
  }

  std::atomic<std::size_t> next_ = 0;
  std::atomic<std::size_t> end_;
  std::mutex mutex_;
  std::exception_ptr exception_;
};

}  // namespace

std::size_t core_count() {
  return std::max(1u, std::thread::hardware_concurrency());
}

void for_each_index(std::size_t count, std::size_t threads,
                    const std::function<void(std::size_t index, std::size_t thread)>& work) {
  Indices indices(count);
  {
    std::vector<std::jthread> others;
    for (std::size_t thread = 1; thread < std::min(threads, count); ++thread) {
      others.emplace_back([&, thread] { indices.work_off(thread, work); });
    }
    indices.work_off(0, work);
  }
  indices.rethrow();
}

}  // namespace mjcourse
