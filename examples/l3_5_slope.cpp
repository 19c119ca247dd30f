// Lesson 3.5: from where a cost can be seen, and what noise does to it.
//
// INPUT    puck_table.xml, a plan of one constant push F along x
// PROCESS  bisect for the smallest push that the puck notices; let MuJoCo cost
//          a range of pushes, and average the costs over normal noise; draw
//          pushes, and count those that reach the puck
// OUTPUT   the smallest push, measured and derived; the slope of the cost and
//          of its averages at no push; the share of draws that reach the puck
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l3_5_slope

#include <cmath>
#include <cstdio>
#include <vector>

#include "l3_5_plan.hpp"

using namespace mjcourse;
using Eigen::Vector2d;

constexpr int N = 100;

Plan constant(double F) {
  return Plan(N, Vector2d(F, 0));
}

// #region notices
bool notices(const mjModel* model, mjData* data, double F) {
  cost_of(model, data, constant(F));
  return data->qpos[2] != 0;  // the puck, after the last step
}

double smallest_push(const mjModel* model, mjData* data) {
  double low = 0, high = 1;
  while (high - low > 1e-9) {
    const double F = (low + high) / 2;
    (notices(model, data, F) ? high : low) = F;
  }
  return high;
}
// #endregion

// What MuJoCo says at F = -3.5, -3.49 ... 4.5, and in between a line.
struct Costs {
  double first = -3.5, step = 0.01;
  std::vector<double> J;
  double at(double F) const {
    const double i = (F - first) / step, whole = std::floor(i);
    const auto k = static_cast<std::size_t>(whole);
    return J[k] + (i - whole) * (J[k + 1] - J[k]);
  }
};

// #region averages
// The mean of the cost over pushes F + sigma e, with e normal, and its slope.
struct Average {
  double cost = 0, slope = 0;
};
Average average(const Costs& costs, double F, double sigma) {
  Average mean;
  const double de = 0.01;
  for (double e = -4; e < 4; e += de) {
    const double p = de * std::exp(-e * e / 2) / std::sqrt(2 * M_PI);
    mean.cost += p * costs.at(F + sigma * e);
    mean.slope += p * costs.at(F + sigma * e) * e / sigma;
  }
  return mean;
}
// #endregion

int main() {
  const Model model = load_model("puck_table");
  const Data data = make_data(model);
  const double h = model->opt.timestep, gap = 0.2, mass = 1;
  const double measured = smallest_push(model, data);
  const double derived = 2 * mass * gap / (h * h * (N - 1) * N);
  std::printf("smallest push that the puck notices: %.5f N, derived %.5f\n",
              measured, derived);
  result("smallest", measured);
  result("derived", derived);

  Costs costs;
  for (int i = 0; i <= 800; ++i)
    costs.J.push_back(
        cost_of(model, data, constant(costs.first + i * costs.step)));
  const double exact = (costs.at(0.01) - costs.at(-0.01)) / 0.02;
  std::printf("slope of the cost at no push:        %7.4f /N\n",
              std::abs(exact));
  result("slope", std::abs(exact));
  for (const double sigma : {0.2, 0.3, 0.5}) {
    const double slope = average(costs, 0, sigma).slope;
    std::printf("  averaged over noise of %.1f N:      %7.4f\n", sigma, slope);
    result("slope_" + std::to_string(std::lround(10 * sigma)), slope);
  }
  std::vector<double> push, sharp, little, much;
  for (double F = -0.5; F < 1.505; F += 0.02) {
    push.push_back(F);
    sharp.push_back(costs.at(F));
    little.push_back(average(costs, F, 0.2).cost);
    much.push_back(average(costs, F, 0.5).cost);
  }
  table("costs",
        {{"push", push}, {"sharp", sharp}, {"little", little}, {"much", much}});

  std::printf("\nnoise (N)  reach the puck  derived\n");
  std::mt19937 random(1);
  std::vector<double> sigmas, shares, formula;
  for (int i = 2; i <= 30; ++i) {
    const double sigma = 0.05 * i;
    sigmas.push_back(sigma);
    formula.push_back(std::erfc(derived / sigma / M_SQRT2) / 2);
    shares.push_back(-1);  // not measured
    if (i != 2 && i != 4 && i != 8 && i != 20 && i != 30) continue;
    const int draws = 400;
    int reach = 0;
    for (int draw = 0; draw < draws; ++draw)
      reach += notices(model, data, sigma * normal(random)) ? 1 : 0;
    shares.back() = static_cast<double>(reach) / draws;
    std::printf("%9.1f  %14.3f  %7.3f\n", sigma, shares.back(), formula.back());
  }
  table("shares",
        {{"sigma", sigmas}, {"measured", shares}, {"derived", formula}});
}
