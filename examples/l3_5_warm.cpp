// Lesson 3.5: planning while time moves on, with a warm start and without.
//
// INPUT    puck_table.xml, and a plan that ten iterations of predictive
//          sampling found
// PROCESS  follow the plan for 1.5 s. Every 10, 50 or 100 ms, plan anew from
//          the state as it is: one iteration with 4 samples, which begins from
//          the rest of the last plan (shifted), from the last plan as it is,
//          or from no push
// OUTPUT   the distance of the puck from the ring at the end, and the cost on
//          the way, as means over two runs; the distance over time, as a table
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l3_5_warm

#include <algorithm>
#include <cstdio>
#include <vector>

#include "l3_5_plan.hpp"

using namespace mjcourse;

constexpr int N = 100, kRuns = 2;
enum Start { kShifted, kAsItIs, kNoPush };

// #region shift
// The plan as it looks some steps later: the first pushes have been
// applied, and as many are needed at the end.
Plan shifted(Plan plan, int by) {
  std::rotate(plan.begin(), plan.begin() + by, plan.end());
  std::fill(plan.end() - by, plan.end(), Eigen::Vector2d::Zero());
  return plan;
}
// #endregion

// #region follow
struct Way {
  double cost = 0;          // of all steps
  std::vector<double> off;  // how far the puck is off after each, in mm
};

Way follow(const mjModel* model, Plan plan, Start start, int every,
           unsigned seed) {
  const Data data = make_data(model);
  std::mt19937 random(seed);
  Way way;
  for (int step = 0; step < 150; ++step) {
    const State now = state_of(data);
    if (step > 0 && step % every == 0) {
      if (start == kShifted) plan = shifted(plan, every);
      if (start == kNoPush) plan = no_push(N);
      plan = best_of(model, plan, {4, 10, 0.2}, random, now);
    }
    const Eigen::Vector2d push = plan[step % every];
    way.cost += step_cost(model, now, push);
    ctrl(model, data) = push;
    mj_step(model, data);
    way.off.push_back(1000 * (state_of(data).segment<2>(2) - goal).norm());
  }
  return way;
}
// #endregion

int main() {
  const Model model = load_model("puck_table");
  std::mt19937 random(1);
  Plan found = no_push(N);
  for (int i = 0; i < 10; ++i)
    found = best_of(model, found, {32, 10, 1.0}, random);

  std::printf("                  off after 1.5 s (mm)      cost on the way\n");
  std::printf(
      "planned every      10 ms  50 ms  100 ms   10 ms  50 ms  100 ms\n");
  const char* names[] = {"the shifted plan", "the plan as it is", "no push"};
  const char* keys[] = {"shifted", "as_it_is", "no_push"};
  std::vector<double> time, off, which;
  for (const Start start : {kShifted, kAsItIs, kNoPush}) {
    std::vector<double> ends, costs;
    for (const int every : {1, 5, 10}) {
      double end = 0, cost = 0;
      for (unsigned seed = 1; seed <= kRuns; ++seed) {
        const Way way = follow(model, found, start, every, seed);
        end += way.off.back() / kRuns;
        cost += way.cost / kRuns;
        if (seed != 1 || every != 10) continue;
        for (std::size_t t = 0; t < way.off.size(); t += 2) {
          time.push_back(static_cast<double>(t) * model->opt.timestep);
          off.push_back(way.off[t]);
          which.push_back(start);
        }
      }
      const std::string key =
          std::string(keys[start]) + "_" + std::to_string(10 * every);
      result(key, end);
      result(key + "_cost", cost);
      ends.push_back(end);
      costs.push_back(cost);
    }
    std::printf("%-17s%7.0f%7.0f%8.0f%8.2f%7.2f%8.2f\n", names[start], ends[0],
                ends[1], ends[2], costs[0], costs[1], costs[2]);
  }
  table("runs", {{"time", time}, {"off", off}, {"which", which}});
}
