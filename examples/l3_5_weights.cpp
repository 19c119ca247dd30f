// Lesson 3.5, exercise: the weights of MPPI.
//
// INPUT    puck_table.xml, a plan of 100 steps, all zero
// PROCESS  20 iterations: 32 noisy plans, and their mean with weights that
//          depend on their costs, at several temperatures
// OUTPUT   what the plans cost, and how many samples have a say in the first
//          iteration; checks the weights
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l3_5_weights

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <vector>

#include "l3_5_plan.hpp"

using namespace mjcourse;

constexpr int N = 100;

// One weight for each cost; they add up to 1.
std::vector<double> weights(const std::vector<double>& costs,
                            double temperature) {
  // #region answer
  const double least = *std::ranges::min_element(costs);
  std::vector<double> w;
  for (const double cost : costs)
    w.push_back(std::exp(-(cost - least) / temperature));
  const double all = std::accumulate(w.begin(), w.end(), 0.0);
  for (double& one : w) one /= all;
  return w;
  // #starter
  // (void)temperature;
  // return std::vector<double>(costs.size(), 1);  // all have the same say
  // #wrong nothing-subtracted: they are numbers
  // std::vector<double> w;
  // for (const double cost : costs)
  //   w.push_back(std::exp(-cost / temperature));
  // const double all = std::accumulate(w.begin(), w.end(), 0.0);
  // for (double& one : w) one /= all;
  // return w;
  // #wrong mean-subtracted: they are numbers
  // const double mean = std::accumulate(costs.begin(), costs.end(), 0.0) /
  //                     static_cast<double>(costs.size());
  // std::vector<double> w;
  // for (const double cost : costs)
  //   w.push_back(std::exp(-(cost - mean) / temperature));
  // const double all = std::accumulate(w.begin(), w.end(), 0.0);
  // for (double& one : w) one /= all;
  // return w;
  // #wrong not-normalised: they add up to 1
  // const double least = *std::ranges::min_element(costs);
  // std::vector<double> w;
  // for (const double cost : costs)
  //   w.push_back(std::exp(-(cost - least) / temperature));
  // return w;
  // #wrong plain-mean: a plan that costs less
  // (void)temperature;
  // const double n = static_cast<double>(costs.size());
  // return std::vector<double>(costs.size(), 1 / n);
  // #wrong dear-plans-win: a plan that costs less
  // const double most = *std::ranges::max_element(costs);
  // std::vector<double> w;
  // for (const double cost : costs)
  //   w.push_back(std::exp((cost - most) / temperature));
  // const double all = std::accumulate(w.begin(), w.end(), 0.0);
  // for (double& one : w) one /= all;
  // return w;
  // #wrong times-the-temperature: a temperature more
  // const double least = *std::ranges::min_element(costs);
  // std::vector<double> w;
  // for (const double cost : costs)
  //   w.push_back(std::exp(-(cost - least) * temperature));
  // const double all = std::accumulate(w.begin(), w.end(), 0.0);
  // for (double& one : w) one /= all;
  // return w;
  // #endregion
}

bool check() {
  for (const double temperature : {1.0, 0.001}) {
    const std::vector<double> w = weights({12.4, 1.3, 1.2, 9.1}, temperature);
    if (!expect(std::ranges::all_of(w, [](double x) { return x >= 0; }),
                "they are numbers, also at a low temperature",
                "exp(-1200) is 0 in a double, and exp(1200) infinite: subtract "
                "something from the costs that makes neither happen"))
      return false;
    if (!expect_near(std::accumulate(w.begin(), w.end(), 0.0), 1, 1e-9,
                     "they add up to 1",
                     "else the mean of pushes of 1 N is no push of 1 N"))
      return false;
  }
  const std::vector<double> w = weights({3.0, 1.0, 2.0}, 2.0);
  if (!expect(w[1] > w[2] && w[2] > w[0],
              "a plan that costs less has the larger weight",
              "the cheapest of three plans should count most"))
    return false;
  return expect_near(w[2] / w[0], std::exp(0.5), 1e-9,
                     "a temperature more of cost divides the weight by e",
                     "here 1 of cost, which is half a temperature");
}

// The mean of the plans, weighted.
Plan mean(const std::vector<Plan>& plans, const std::vector<double>& w) {
  Plan all = no_push(N);
  for (std::size_t k = 0; k < plans.size(); ++k)
    for (int t = 0; t < N; ++t) all[t] += w[k] * plans[k][t];
  return all;
}

int main() {
  if (!check()) return 0;
  const Model model = load_model("puck_table");
  const Data data = make_data(model);
  std::printf("temperature  have a say   cost after 20\n");
  std::vector<double> which, iteration, costs_after;
  for (const double temperature : {0.01, 0.1, 1.0, 10.0}) {
    std::mt19937 random(1);
    Plan plan = no_push(N);
    double say = 0;
    for (int i = 0; i < 20; ++i) {
      std::vector<Plan> plans{plan};
      while (plans.size() <= 32)
        plans.push_back(sum(plan, noise(N, {32, 10, 1.0}, random)));
      std::vector<double> costs;
      for (const Plan& tried : plans)
        costs.push_back(cost_of(model, data, tried));
      const std::vector<double> w = weights(costs, temperature);
      double squares = 0;
      for (const double one : w) squares += one * one;
      if (i == 0) say = 1 / squares;
      plan = mean(plans, w);
    }
    std::printf("%11.2f  %10.1f  %14.2f\n", temperature, say,
                cost_of(model, data, plan));
  }
}
