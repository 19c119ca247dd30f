// Lesson 3.5, challenge: a slope out of noise.
//
// INPUT    puck_table.xml, a plan of 100 steps, all zero
// PROCESS  estimate the slope of the averaged cost from 64 rollouts, and go a
//          little way down it; 30 times
// OUTPUT   the largest push's slope at the start, and what the plan costs;
//          checks the estimate on costs whose slope is known
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l3_5_gradient

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "l3_5_plan.hpp"

using namespace mjcourse;
using Eigen::Vector2d;

// The slope of the averaged cost by each push of a plan. `costs[k]` is that of
// the plan with noises[k] on it, and `base` that of the plan itself.
Plan slope_of(const std::vector<Plan>& noises, const std::vector<double>& costs,
              double base, double sigma) {
  // #region answer
  Plan slope = no_push(static_cast<int>(noises[0].size()));
  const double all = static_cast<double>(noises.size());
  for (std::size_t k = 0; k < noises.size(); ++k)
    for (std::size_t t = 0; t < slope.size(); ++t)
      slope[t] += (costs[k] - base) * noises[k][t] / (sigma * sigma * all);
  return slope;
  // #starter
  // (void)costs, (void)base, (void)sigma;
  // return no_push(static_cast<int>(noises[0].size()));
  // #wrong no-base: a constant in the cost
  // (void)base;
  // Plan slope = no_push(static_cast<int>(noises[0].size()));
  // const double all = static_cast<double>(noises.size());
  // for (std::size_t k = 0; k < noises.size(); ++k)
  //   for (std::size_t t = 0; t < slope.size(); ++t)
  //     slope[t] += costs[k] * noises[k][t] / (sigma * sigma * all);
  // return slope;
  // #wrong one-sigma: noise of another size
  // Plan slope = no_push(static_cast<int>(noises[0].size()));
  // const double all = static_cast<double>(noises.size());
  // for (std::size_t k = 0; k < noises.size(); ++k)
  //   for (std::size_t t = 0; t < slope.size(); ++t)
  //     slope[t] += (costs[k] - base) * noises[k][t] / (sigma * all);
  // return slope;
  // #wrong a-sum: it is the slope of a cost
  // Plan slope = no_push(static_cast<int>(noises[0].size()));
  // for (std::size_t k = 0; k < noises.size(); ++k)
  //   for (std::size_t t = 0; t < slope.size(); ++t)
  //     slope[t] += (costs[k] - base) * noises[k][t] / (sigma * sigma);
  // return slope;
  // #wrong downhill: it is the slope of a cost
  // Plan slope = no_push(static_cast<int>(noises[0].size()));
  // const double all = static_cast<double>(noises.size());
  // for (std::size_t k = 0; k < noises.size(); ++k)
  //   for (std::size_t t = 0; t < slope.size(); ++t)
  //     slope[t] -= (costs[k] - base) * noises[k][t] / (sigma * sigma * all);
  // return slope;
  // #endregion
}

// A cost with the slope (3, -1), (0, 2): estimated from 20000 draws.
Eigen::Vector4d estimated(double constant, double sigma) {
  std::mt19937 random(1);
  std::vector<Plan> noises;
  std::vector<double> costs;
  for (int k = 0; k < 20000; ++k) {
    noises.push_back(noise(2, {0, 1, sigma}, random));
    const Plan& e = noises.back();
    costs.push_back(constant + 3 * e[0][0] - e[0][1] + 2 * e[1][1]);
  }
  const Plan slope = slope_of(noises, costs, constant, sigma);
  return {slope[0][0], slope[0][1], slope[1][0], slope[1][1]};
}

bool check() {
  const Eigen::Vector4d slope(3, -1, 0, 2);
  return expect_near(estimated(0, 1), slope, 0.15,
                     "it is the slope of a cost that is a plane",
                     "with noise of 1 N: a mean of cost times noise") &&
         expect_near(estimated(0, 0.1), slope, 0.15,
                     "noise of another size gives the same slope",
                     "cost times noise grows with the square of sigma") &&
         expect_near(estimated(1000, 1), slope, 0.15,
                     "a constant in the cost does not matter",
                     "1000 times the noise has the mean 0, but not for a "
                     "finite number of draws: subtract the base first");
}

int main() {
  if (!check()) return 0;
  const Model model = load_model("puck_table");
  const Data data = make_data(model);
  const int N = 100, kSamples = 64;
  const Sampling by{kSamples, 10, 1.0};
  std::mt19937 random(1);
  Plan plan = no_push(N);
  std::printf("iteration   steepest    cost\n");
  for (int i = 0; i <= 30; ++i) {
    const double base = cost_of(model, data, plan);
    std::vector<Plan> noises;
    std::vector<double> costs;
    for (int k = 0; k < kSamples; ++k) {
      noises.push_back(noise(N, by, random));
      costs.push_back(cost_of(model, data, sum(plan, noises.back())));
    }
    const Plan slope = slope_of(noises, costs, base, by.sigma);
    double steepest = 0;
    for (const Vector2d& s : slope)
      steepest = std::max(steepest, s.cwiseAbs().maxCoeff());
    if (i % 10 == 0) std::printf("%9d  %9.2f  %6.2f\n", i, steepest, base);
    if (i == 0) result("sigma", by.sigma);
    if (i == 0) result("steepest", steepest);
    if (i == 30) result("cost", base);
    const double rate = 0.3 / steepest;  // at most 0.3 N
    for (int t = 0; t < N; ++t) plan[t] -= rate * slope[t];
  }
}
