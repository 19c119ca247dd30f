#include "evaluate/task_queue.h"

#include <algorithm>
#include <tuple>
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
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    list_of(tasks[i]->waits_for_programs() ? held_ : ready_, i).push_back(i);
    programs_ += is_program(*tasks[i]) ? 1 : 0;
    const bool is_first = first.contains({tasks[i]->lesson().source->path(), tasks[i]->block()});
    weights_.push_back({is_first, tasks[i]->effort()});
  }
  for (auto* list : {&ready_.drawn, &ready_.compiled, &ready_.others, &held_.drawn, &held_.compiled,
                     &held_.others}) {
    std::stable_sort(list->rbegin(), list->rend(),
                     [&](std::size_t a, std::size_t b) { return weights_[a] > weights_[b]; });
  }
  if (programs_ == 0) release();
}

std::vector<std::size_t>& TaskQueue::list_of(Ready& tasks, std::size_t task) const {
  if (tasks_[task]->draws()) return tasks.drawn;
  return tasks_[task]->compiles() ? tasks.compiled : tasks.others;
}

void TaskQueue::release() {
  publish_();
  // What was held back is behind what is ready, and quick: the threads that wait are few.
  ready_.drawn.insert(ready_.drawn.begin(), held_.drawn.begin(), held_.drawn.end());
  ready_.compiled.insert(ready_.compiled.begin(), held_.compiled.begin(), held_.compiled.end());
  ready_.others.insert(ready_.others.begin(), held_.others.begin(), held_.others.end());
  held_ = {};
  changed_.notify_all();
}

std::vector<std::size_t>* TaskQueue::next_list(std::size_t thread) {
  std::vector<std::vector<std::size_t>*> lists{&ready_.drawn, &ready_.others};
  if (compiling_ != Programs::held) lists.push_back(&ready_.compiled);
  std::erase_if(lists, [](const auto* list) { return list->empty(); });
  if (lists.empty()) return nullptr;
  return *std::ranges::max_element(lists, {}, [&](const auto* list) {
    const bool draws = list == &ready_.drawn;
    const bool compiles = list == &ready_.compiled;
    const bool waits = (draws && drawer_.value_or(thread) != thread) ||
                       (compiles && compiling_ != Programs::usual);
    const Weight& weight = weights_[list->back()];
    return std::tuple(weight.first, !waits, draws, weight.effort);
  });
}

void TaskQueue::programs_known() {
  const std::lock_guard lock(mutex_);
  compiling_ = Programs::last;
  changed_.notify_all();
}

void TaskQueue::headers_made() {
  const std::lock_guard lock(mutex_);
  compiling_ = Programs::usual;
}

std::optional<std::size_t> TaskQueue::next(std::size_t thread) {
  std::unique_lock lock(mutex_);
  std::vector<std::size_t>* list = nullptr;
  changed_.wait(lock, [&] {
    list = next_list(thread);
    return list != nullptr || (ready_.empty() && held_.empty());
  });
  if (list == nullptr) return std::nullopt;
  const std::size_t task = list->back();
  list->pop_back();
  if (tasks_[task]->draws() && !drawer_) drawer_ = thread;
  return task;
}

void TaskQueue::finish(std::size_t task) {
  const std::lock_guard lock(mutex_);
  if (is_program(*tasks_[task]) && --programs_ == 0) release();
}

void TaskQueue::stop() {
  const std::lock_guard lock(mutex_);
  ready_ = held_ = {};
  changed_.notify_all();
}

}  // namespace mjcourse
