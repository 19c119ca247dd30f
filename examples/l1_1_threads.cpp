// Lesson 1.1: one model, many data, in threads.
//
// INPUT    arm_and_crate.xml
// PROCESS  (1) simulate a second eight times with eight different targets, one
//              after the other, then in eight threads on the same model, each
//              with data of its own; compare all numbers, bit by bit;
//          (2) let two threads take turns on one mjData, behind a lock;
//          (3) the same, but each stops when the shared clock says a second
// OUTPUT   whether all bits agree, and what time it is in the shared data; for
//          the lesson, how many steps (3) took
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l1_1_threads

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <mjcourse/mjcourse.hpp>
#include <mutex>
#include <thread>
#include <vector>

using namespace mjcourse;
using Eigen::VectorXd;

bool same_bits(const VectorXd& a, const VectorXd& b) {
  return a.size() == b.size() &&
         std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

// #region rollout
// The pose after a second with this target for the shoulder. All that changes
// is in `data`, which nobody else has.
VectorXd rollout(const mjModel* model, double shoulder) {
  const Data data = make_data(model);
  ctrl(model, data) << shoulder, 1.2;
  for (int step = 0; step < 500; ++step) mj_step(model, data);
  return qpos(model, data);
}

bool same_in_threads(const mjModel* model, const std::vector<double>& targets) {
  std::vector<VectorXd> alone, together(targets.size());
  for (const double target : targets) alone.push_back(rollout(model, target));
  {
    std::vector<std::jthread> threads;
    for (std::size_t k = 0; k < targets.size(); ++k)
      threads.emplace_back(
          [&, k] { together[k] = rollout(model, targets[k]); });
  }  // each jthread is joined here
  return std::ranges::equal(alone, together, same_bits);
}
// #endregion

// #region shared
// Two threads want a second each, and both step the same data.
double time_in_shared_data(const mjModel* model) {
  const Data data = make_data(model);
  std::mutex mutex;
  const auto a_second = [&] {
    for (int step = 0; step < 500; ++step) {
      const std::lock_guard lock(mutex);
      mj_step(model, data);
    }
  };
  { const std::jthread one(a_second), other(a_second); }
  return data->time;
}
// #endregion

int steps_by_the_clock(const mjModel* model) {
  const Data data = make_data(model);
  std::mutex mutex;
  int steps = 0;
  const auto a_second = [&] {
    while (true) {
      const std::lock_guard lock(mutex);
      if (data->time >= 1) return;
      mj_step(model, data);
      ++steps;
    }
  };
  { const std::jthread one(a_second), other(a_second); }
  return steps;
}

int main() {
  const Model model = load_model("arm_and_crate");
  const std::vector<double> targets{0.2, 0.4, 0.6, 0.8, 1.0, 1.2, 1.4, 1.6};
  std::printf("eight data, eight threads: %s\n",
              same_in_threads(model, targets) ? "the same bits as one by one"
                                              : "other numbers");
  const double time = time_in_shared_data(model);
  std::printf("one data, two threads:     time %.3f s instead of 1\n", time);
  result("shared_time", time);
  result("steps_by_the_clock", steps_by_the_clock(model));
  result("threads", static_cast<double>(targets.size()));
}
