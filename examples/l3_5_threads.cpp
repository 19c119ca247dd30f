// Lesson 3.5: rollouts in threads, with the same plan from any number of them.
//
// INPUT    puck_table.xml, a plan of 100 steps, all zero
// PROCESS  ten iterations of predictive sampling in 1, 2 and 4 threads: with
//          noise that is drawn before the work is dealt, and with a random
//          generator of its own in each thread
// OUTPUT   the costs, and whether the plans are the same to the last bit
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l3_5_threads

#include <algorithm>
#include <cstdio>
#include <functional>
#include <thread>
#include <vector>

#include "l3_5_plan.hpp"

using namespace mjcourse;

constexpr int N = 100, kSamples = 32;
const Sampling by{kSamples, 10, 1.0};

// #region deal
// Every thread has data of its own; all share the model. Thread number i
// takes the plans i, i + threads, i + 2 threads ...
std::vector<double> costs_of(const mjModel* model,
                             const std::vector<Plan>& plans, int threads) {
  std::vector<double> costs(plans.size());
  const auto work = [&](int thread) {
    const Data data = make_data(model);
    for (std::size_t k = thread; k < plans.size(); k += threads)
      costs[k] = cost_of(model, data, plans[k]);
  };
  {
    std::vector<std::jthread> pool;
    for (int i = 0; i < threads; ++i) pool.emplace_back(work, i);
  }  // each is joined here
  return costs;
}

Plan iteration(const mjModel* model, const Plan& plan, int threads,
               std::mt19937& random) {
  std::vector<Plan> plans{plan};  // all noise is drawn here, in this order
  while (plans.size() <= kSamples)
    plans.push_back(sum(plan, noise(N, by, random)));
  const std::vector<double> costs = costs_of(model, plans, threads);
  return plans[std::ranges::min_element(costs) - costs.begin()];
}
// #endregion

// Here the threads draw, each with a generator of its own.
Plan drawn_in_threads(const mjModel* model, const Plan& plan, int threads,
                      std::vector<std::mt19937>& random) {
  std::vector<Plan> plans(kSamples + 1, plan);
  const auto work = [&](int thread) {
    for (int k = 1 + thread; k <= kSamples; k += threads)
      plans[k] = sum(plan, noise(N, by, random[thread]));
  };
  {
    std::vector<std::jthread> pool;
    for (int i = 0; i < threads; ++i) pool.emplace_back(work, i);
  }
  const std::vector<double> costs = costs_of(model, plans, threads);
  return plans[std::ranges::min_element(costs) - costs.begin()];
}

int main() {
  const Model model = load_model("puck_table");
  const Data data = make_data(model);
  Plan first, first_own;
  std::printf("threads  drawn before     in each thread\n");
  for (const int threads : {1, 2, 4}) {
    Plan plan = no_push(N), own = no_push(N);
    std::mt19937 random(1);
    std::vector<std::mt19937> generators;
    for (int i = 0; i < threads; ++i) generators.emplace_back(i + 1);
    for (int i = 0; i < 10; ++i) {
      plan = iteration(model, plan, threads, random);
      own = drawn_in_threads(model, own, threads, generators);
    }
    if (threads == 1) {
      first = plan;
      first_own = own;
    }
    const char* same = plan == first ? "same" : "differs";
    const char* same_own = own == first_own ? "same" : "differs";
    std::printf("%7d  %.4f  %-7s  %.4f  %s\n", threads,
                cost_of(model, data, plan), same, cost_of(model, data, own),
                same_own);
  }
}
