// Lesson 3.5: a push that sampling finds, and that a gradient does not.
//
// INPUT    puck_table.xml, a plan of 100 steps of 10 ms, all zero
// PROCESS  improve the plan by iLQR; by predictive sampling; by iLQR from what
//          sampling found in five iterations; and by iLQR from a constant push
// OUTPUT   what each plan costs, and how many steps of MuJoCo that took; the
//          costs as a table; for the lesson, the slope of the cost, and what
//          becomes of iLQR without a line search
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l3_5_push

#include <algorithm>
#include <cstdio>
#include <vector>

#include "l3_5_plan.hpp"

using namespace mjcourse;
using Eigen::Matrix2d, Eigen::RowMajor, Eigen::Vector2d;
using Matrix8d = Eigen::Matrix<double, 8, 8>;
using Matrix28d = Eigen::Matrix<double, 2, 8>;

constexpr int N = 100;  // steps of a plan
const Sampling kSampling{32, 10, 1.0};
constexpr int kColumns = 2 * (8 + 2);  // steps that the differences take

struct Feedback {
  Plan k;                    // what to add to each push
  std::vector<Matrix28d> K;  // and how to answer to a change of the state
  double slope = 0;          // of the cost, by any push, at the most
};

// #region backward
// From the last step to the first. Vx and Vxx are the slope and the
// curvature of the cost from there on, by a change of the state.
Feedback backward(const mjModel* model, const Plan& plan, const Path& path,
                  double mu) {
  const Data data = make_data(model);
  const double h = model->opt.timestep;
  Feedback found{no_push(N), std::vector<Matrix28d>(N)};
  State Vx = State::Zero(), slope = State::Zero();
  Vx.segment<2>(2) = 2 * kMiss * (path[N].segment<2>(2) - goal);
  Vx.segment<2>(6) = 2 * kRush * path[N].segment<2>(6);
  Matrix8d Vxx = Matrix8d::Zero();
  Vxx.diagonal() << 0, 0, 2 * kMiss, 2 * kMiss, 0, 0, 2 * kRush, 2 * kRush;
  slope = Vx;
  for (int t = N - 1; t >= 0; --t) {
    Eigen::Matrix<double, 8, 8, RowMajor> A;
    Eigen::Matrix<double, 8, 2, RowMajor> B;
    set_state(model, data, path[t]);
    ctrl(model, data) = plan[t];
    mjd_transitionFD(model, data, 1e-6, 1, A.data(), B.data(), nullptr,
                     nullptr);
    State lx = State::Zero();  // of this step's own cost
    lx.segment<2>(2) = 2 * h * kAway * (path[t].segment<2>(2) - goal);
    const Vector2d lu = 2 * h * kEffort * plan[t];

    const State Qx = lx + A.transpose() * Vx;
    const Vector2d Qu = lu + B.transpose() * Vx;
    Matrix8d Qxx = A.transpose() * Vxx * A;
    Qxx.diagonal().segment<2>(2).array() += 2 * h * kAway;
    const Matrix28d Qux = B.transpose() * Vxx * A;
    Matrix2d Quu = B.transpose() * Vxx * B;
    Quu.diagonal().array() += 2 * h * kEffort;
    const auto S = (Quu + mu * Matrix2d::Identity()).eval().ldlt();
    const Vector2d k = found.k[t] = -S.solve(Qu);
    const Matrix28d K = found.K[t] = -S.solve(Qux);

    Vx = Qx + K.transpose() * (Quu * k + Qu) + Qux.transpose() * k;
    Vxx = Qxx + K.transpose() * Quu * K + K.transpose() * Qux +
          Qux.transpose() * K;
    const Vector2d by_push = lu + B.transpose() * slope;
    found.slope = std::max(found.slope, by_push.cwiseAbs().maxCoeff());
    slope = lx + A.transpose() * slope;
  }
  return found;
}
// #endregion

// #region forward
// The plan with a share of the change, and with the feedback on the way.
Plan forward(const mjModel* model, mjData* data, const Plan& plan,
             const Path& path, const Feedback& by, double share) {
  Plan next = plan;
  set_state(model, data, path[0]);
  for (int t = 0; t < N; ++t) {
    next[t] += share * by.k[t] + by.K[t] * (state_of(data) - path[t]);
    ctrl(model, data) = next[t];
    mj_step(model, data);
  }
  return next;
}
// #endregion

// What has been planned so far.
struct Progress {
  Plan plan;
  double mu = 1e-4, slope = 0;
  long steps = 0;
};

// #region iteration
// An iteration of iLQR. Shares are halved until the cost falls; where
// none helps, mu grows, which makes the next change smaller.
void ilqr(const mjModel* model, Progress& now, bool line_search = true) {
  const Data data = make_data(model);
  Path path;
  const double cost = cost_of(model, data, now.plan, State::Zero(), &path);
  const Feedback by = backward(model, now.plan, path, now.mu);
  now.steps += N + N * kColumns;
  now.slope = by.slope;
  for (double share = 1; share > 0.01; share /= 2) {
    const Plan next = forward(model, data, now.plan, path, by, share);
    now.steps += N;  // cost_of below could be spared
    if (!line_search || cost_of(model, data, next) < cost) {
      now.plan = next;
      now.mu = std::max(now.mu / 4, 1e-6);
      return;
    }
  }
  now.mu = std::min(now.mu * 10, 1.0);
}
// #endregion

void sample(const mjModel* model, Progress& now, std::mt19937& random) {
  now.plan = best_of(model, now.plan, kSampling, random);
  now.steps += N * (kSampling.samples + 1);
}

// A table for the lesson.
struct Curve {
  std::vector<double> which, steps, iteration, cost;
  double add(int curve, int i, const mjModel* model, const Progress& now) {
    const Data data = make_data(model);
    which.push_back(curve);
    iteration.push_back(i);
    steps.push_back(static_cast<double>(now.steps));
    cost.push_back(cost_of(model, data, now.plan));
    return cost.back();
  }
};

void print_row(const char* name, int iterations, const Progress& now,
               double cost) {
  std::printf("%-28s %4d %7ld %9.3f\n", name, iterations, now.steps, cost);
}

// Where the plan leads, for the lesson.
void record_path(const mjModel* model, mjData* data, const Plan& plan) {
  Path path;
  cost_of(model, data, plan, State::Zero(), &path);
  snapshot("end", model, data);
  const double off = (path[N].segment<2>(2) - goal).norm();
  result("off_mm", std::lround(1000 * off));
  std::vector<double> time, x, y, puck_x, puck_y, push_x, push_y;
  for (int t = 0; t < N; ++t) {
    time.push_back(t * model->opt.timestep);
    x.push_back(path[t][0] - 0.3);
    y.push_back(path[t][1]);
    puck_x.push_back(path[t][2]);
    puck_y.push_back(path[t][3]);
    push_x.push_back(plan[t][0]);
    push_y.push_back(plan[t][1]);
  }
  table("path", {{"time", time},
                 {"x", x},
                 {"y", y},
                 {"puck x", puck_x},
                 {"puck y", puck_y},
                 {"push x", push_x},
                 {"push y", push_y}});
}

int main() {
  const Model model = load_model("puck_table");
  const Data data = make_data(model);
  Curve curve;
  std::printf("planner                iterations   steps      cost\n");

  Progress blind{no_push(N)};
  const double at_first = curve.add(0, 0, model, blind);
  print_row("no push", 0, blind, at_first);
  double cost = 0;
  for (int i = 1; i <= 10; ++i) {
    ilqr(model, blind);
    cost = curve.add(0, i, model, blind);
  }
  print_row("iLQR", 10, blind, cost);
  result("samples", kSampling.samples);
  result("sampling_steps", N * (kSampling.samples + 1));
  result("ilqr_steps", N + N * kColumns + N);
  result("at_first", at_first);
  result("blind", cost);
  result("blind_slope", blind.slope);
  result("blind_steps", blind.steps);

  Progress noisy{no_push(N)}, both;
  std::mt19937 random(1);
  curve.add(1, 0, model, noisy);
  for (int i = 1; i <= 50; ++i) {
    sample(model, noisy, random);
    cost = curve.add(1, i, model, noisy);
    if (i == 5) {
      both = noisy;
      print_row("sampling", i, noisy, cost);
      result("found", cost);
      result("found_steps", noisy.steps);
    }
  }
  print_row("sampling", 50, noisy, cost);
  result("sampled", cost);
  result("sampled_steps", noisy.steps);

  curve.add(2, 5, model, both);
  double overtaken = 0;
  for (int i = 1; i <= 15; ++i) {
    ilqr(model, both);
    const double now = curve.add(2, 5 + i, model, both);
    if (overtaken == 0 && now < cost)
      overtaken = static_cast<double>(both.steps);
    if (i == 15) cost = now;
  }
  print_row("sampling, 5, then iLQR, 15", 20, both, cost);
  result("both", cost);
  result("both_steps", both.steps);
  result("overtaken", overtaken);

  // A guess instead of a search, with a line search and without.
  double worst = 0;
  for (const bool search : {true, false}) {
    Progress guess{Plan(N, Vector2d(0.5, 0))};
    const double begin = curve.add(search ? 3 : 4, 0, model, guess);
    for (int i = 1; i <= 10; ++i) {
      ilqr(model, guess, search);
      cost = curve.add(search ? 3 : 4, i, model, guess);
      if (!search) worst = std::max(worst, cost);
    }
    if (search) print_row("0.5 N by hand, then iLQR", 10, guess, cost);
    if (search) record_path(model, data, guess.plan);
    if (search) result("guess_steps", guess.steps);
    if (search) result("guess_at_first", begin);
    result(search ? "guess" : "guess_full", cost);
  }
  std::printf("steepest slope of the cost at no push: %g\n", blind.slope);
  result("worst", worst);
  table("costs", {{"which", curve.which},
                  {"iteration", curve.iteration},
                  {"steps", curve.steps},
                  {"cost", curve.cost}});
}
