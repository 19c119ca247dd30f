// What the programs of lesson 3.5 share: the task, what a plan costs, noise,
// and an iteration of predictive sampling.
//
//   Plan plan = no_push(100);
//   const double cost = cost_of(model, data, plan);
//   plan = best_of(model, plan, {32, 10, 1.0}, random);
//
// The task: puck_table.xml, whose puck is to come to the ring.
#pragma once

#include <cmath>
#include <mjcourse/mjcourse.hpp>
#include <random>
#include <vector>

namespace mjcourse {

using Plan = std::vector<Eigen::Vector2d>;  // a push for each step, in N
using State = Eigen::Matrix<double, 8, 1>;  // qpos, qvel: pusher, puck
using Path = std::vector<State>;            // one more than the plan has steps

inline Plan no_push(int steps) {
  return Plan(steps, Eigen::Vector2d::Zero());
}

inline State state_of(const mjData* data) {
  State x;
  x << Eigen::Vector4d(data->qpos), Eigen::Vector4d(data->qvel);
  return x;
}

// As fresh data, but at this state: nothing of the last rollout is left.
inline void set_state(const mjModel* model, mjData* data, const State& x) {
  mj_resetData(model, data);
  Eigen::Map<Eigen::Vector4d>(data->qpos) = x.head<4>();
  Eigen::Map<Eigen::Vector4d>(data->qvel) = x.tail<4>();
}

// ---- the cost ---------------------------------------------------------------

inline const Eigen::Vector2d goal(0.3, 0.15);  // m
inline constexpr double kAway = 10;            // of a second away, 1/m^2
inline constexpr double kEffort = 0.05;        // of a second of 1 N
inline constexpr double kMiss = 100;           // at the end, 1/m^2
inline constexpr double kRush = 1;             // at the end, s^2/m^2

inline double step_cost(const mjModel* model, const State& x,
                        const Eigen::Vector2d& push) {
  const double away = (x.segment<2>(2) - goal).squaredNorm();
  return model->opt.timestep * (kAway * away + kEffort * push.squaredNorm());
}
inline double end_cost(const State& x) {
  return kMiss * (x.segment<2>(2) - goal).squaredNorm() +
         kRush * x.segment<2>(6).squaredNorm();
}

// A rollout: simulates the plan from `start`, adds up the cost, and keeps the
// states where `path` is given. The data is its own for that time.
inline double cost_of(const mjModel* model, mjData* data, const Plan& plan,
                      const State& start = State::Zero(),
                      Path* path = nullptr) {
  set_state(model, data, start);
  double cost = 0;
  if (path != nullptr) path->assign(1, start);
  for (const Eigen::Vector2d& push : plan) {
    cost += step_cost(model, state_of(data), push);
    ctrl(model, data) = push;
    mj_step(model, data);
    if (path != nullptr) path->push_back(state_of(data));
  }
  return cost + end_cost(state_of(data));
}

// ---- noise ------------------------------------------------------------------

// A normal number with mean 0 and variance 1, by Box and Muller. It is the same
// with every C++ library, which std::normal_distribution is not.
inline double normal(std::mt19937& random) {
  const double a = (random() + 1.0) / 4294967296.0;
  const double b = random() / 4294967296.0;
  return std::sqrt(-2 * std::log(a)) * std::cos(2 * M_PI * b);
}

struct Sampling {
  int samples;   // rollouts in an iteration, without that of the plan
  int hold;      // steps that share a push of the noise
  double sigma;  // of the noise, N
};

inline Plan noise(int steps, const Sampling& by, std::mt19937& random) {
  Plan plan = no_push(steps);
  for (int t = 0; t < steps; ++t) {
    if (t % by.hold != 0) {
      plan[t] = plan[t - 1];
      continue;
    }
    plan[t][0] = by.sigma * normal(random);
    plan[t][1] = by.sigma * normal(random);
  }
  return plan;
}

inline Plan sum(Plan plan, const Plan& other) {
  for (std::size_t t = 0; t < plan.size(); ++t) plan[t] += other[t];
  return plan;
}

// ---- predictive sampling ----------------------------------------------------

// The best of the plan and of `samples` noisy copies of it.
inline Plan best_of(const mjModel* model, const Plan& plan, const Sampling& by,
                    std::mt19937& random, const State& start = State::Zero()) {
  const Data data = make_data(model);
  Plan best = plan;
  double least = cost_of(model, data, plan, start);
  for (int k = 0; k < by.samples; ++k) {
    const Plan tried =
        sum(plan, noise(static_cast<int>(plan.size()), by, random));
    const double cost = cost_of(model, data, tried, start);
    if (cost < least) {
      best = tried;
      least = cost;
    }
  }
  return best;
}

}  // namespace mjcourse
