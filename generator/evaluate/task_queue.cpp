#include "evaluate/task_queue.h"

#include <algorithm>
#include <utility>

#include "evaluate/program_task.h"

namespace mjcourse {
namespace {

bool is_program(const Task& task) {
  return dynamic_cast<const ProgramTask*>(&task) != nullptr;
}

}  // namespace

TaskQueue::TaskQueue(const Tasks& tasks, const Blocks& first, std::function<void()> publish)
    : tasks_(tasks), publish_(std::move(publish)) {
  std::vector<std::pair<bool, double>> weight;
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    (tasks[i]->quotes() ? held_ : ready_).push_back(i);
    programs_ += is_program(*tasks[i]) ? 1 : 0;
    const bool is_first = first.contains({tasks[i]->lesson().source->path(), tasks[i]->block()});
    weight.emplace_back(is_first, tasks[i]->effort());
  }
  for (auto* list : {&ready_, &held_}) {
    std::stable_sort(list->rbegin(), list->rend(),
                     [&](std::size_t a, std::size_t b) { return weight[a] > weight[b]; });
  }
  if (programs_ == 0) release();
}

void TaskQueue::release() {
  publish_();
  // What was held back is behind what is ready, and quick: those who wait are few.
  ready_.insert(ready_.begin(), held_.begin(), held_.end());
  held_.clear();
  changed_.notify_all();
}

std::optional<std::size_t> TaskQueue::next() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return !ready_.empty() || held_.empty(); });
  if (ready_.empty()) return std::nullopt;
  const std::size_t task = ready_.back();
  ready_.pop_back();
  return task;
}

void TaskQueue::finish(std::size_t task) {
  if (!is_program(*tasks_[task])) return;
  const std::lock_guard lock(mutex_);
  if (--programs_ == 0) release();
}

void TaskQueue::stop() {
  const std::lock_guard lock(mutex_);
  ready_.clear();
  held_.clear();
  changed_.notify_all();
}

}  // namespace mjcourse
