// Lesson 1.1, challenge: look ahead in threads, then act on it.
//
// INPUT    arm_and_crate.xml, 0.5 s after its arm began to move
// PROCESS  copy the data for each of 16 candidate targets; in two threads, let
//          each copy go on for a second and measure how far the crate got;
//          then give the best target to the original
// OUTPUT   the best target, the foreseen result and the actual one; exits with 1
//          where the two differ by a bit
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l1_1_look_ahead

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <mjcourse/mjcourse.hpp>
#include <thread>
#include <vector>

using namespace mjcourse;

struct Crate {
  double x, tilt;  // m along x, degrees off the vertical
};

// Lets `data` go on for a second with this target for the elbow, and says how
// the crate is then.
Crate go_on(const mjModel* model, mjData* data, double elbow) {
  ctrl(model, data)[1] = elbow;
  for (int step = 0; step < 500; ++step) mj_step(model, data);
  mj_kinematics(model, data);  // else xpos and xmat would be a step old
  const int crate = id_of(model, mjOBJ_BODY, "crate");
  const double up = std::clamp(data->xmat[9 * crate + 8], -1.0, 1.0);
  return {data->xpos[3 * crate], std::acos(up) * 180 / M_PI};
}

// The outcome of each candidate. Neither `model` nor `now` is written to:
// both are only read while the threads run.
std::vector<Crate> foresee(const mjModel* model, const mjData* now,
                           const std::vector<double>& candidates) {
  std::vector<Crate> outcomes(candidates.size());
  const auto work = [&](std::size_t first) {
    const Data copy = make_data(model);  // one for each thread
    for (std::size_t k = first; k < candidates.size(); k += 2) {
      mj_copyData(copy, model, now);
      outcomes[k] = go_on(model, copy, candidates[k]);
    }
  };
  { const std::jthread even(work, 0), odd(work, 1); }
  return outcomes;
}

int main() {
  const Model model = load_model("arm_and_crate");
  const Data data = make_data(model);
  ctrl(model, data) << 1.4, 1.8;  // rad, for shoulder and elbow
  for (int step = 0; step < 250; ++step) mj_step(model, data);

  std::vector<double> candidates;
  for (int k = 0; k < 16; ++k) candidates.push_back(0.1 * k);
  std::vector<double> reached, tilt;
  for (const Crate& crate : foresee(model, data, candidates)) {
    reached.push_back(crate.x);
    tilt.push_back(crate.tilt);
  }
  const auto best = std::max_element(reached.begin(), reached.end());
  const double target = candidates[best - reached.begin()];

  const double came = go_on(model, data, target).x;
  std::printf("best target of the elbow: %.1f rad\n", target);
  std::printf("crate, foreseen: %.3f m\n", *best);
  std::printf("crate, in fact:  %.3f m\n", came);
  std::printf("the same bits: %s\n", came == *best ? "yes" : "no");
  result("target", target);
  result("reached", came);
  result("worst", *std::min_element(reached.begin(), reached.end()));
  table("candidates",
        {{"target", candidates}, {"reached", reached}, {"tilt", tilt}});
  snapshot("pushed", model, data);
  return came == *best ? 0 : 1;
}
