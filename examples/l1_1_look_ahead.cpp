// Lesson 1.1, challenge: look ahead in threads, then act on it.
//
// INPUT    arm_and_crate.xml, 0.5 s after its arm began to move
// PROCESS  copy the data for each of 16 candidate targets; in two threads, let
//          each copy go on for a second and measure how far the crate got;
//          then give the best target to the original
// OUTPUT   the best target, the foreseen result and the actual one; checks that
//          the two have the same bits, and that the order does not matter
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l1_1_look_ahead

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <mjcourse/mjcourse.hpp>
#include <mutex>
#include <set>
#include <thread>
#include <vector>

using namespace mjcourse;

struct Crate {
  double x, tilt;  // m along x, degrees off the vertical
};

std::mutex mutex;
std::set<std::thread::id> threads;  // in which something went on

// Lets `data` go on for a second with this target for the elbow, and says how
// the crate is then.
Crate go_on(const mjModel* model, mjData* data, double elbow) {
  {
    const std::lock_guard lock(mutex);
    threads.insert(std::this_thread::get_id());
  }
  ctrl(model, data)[1] = elbow;
  for (int step = 0; step < 500; ++step) mj_step(model, data);
  mj_kinematics(model, data);  // else xpos and xmat would be a step old
  const int crate = id_of(model, mjOBJ_BODY, "crate");
  const double up = std::clamp(data->xmat[9 * crate + 8], -1.0, 1.0);
  return {data->xpos[3 * crate], std::acos(up) * 180 / M_PI};
}

// The outcome of each of the candidates, which are targets for the elbow, in
// their order: each is tried on a copy of `now`, by go_on, in one of two
// threads. Neither `model` nor `now` is written to: both are only read while
// the threads run.
std::vector<Crate> foresee(const mjModel* model, const mjData* now,
                           const std::vector<double>& candidates) {
  // #region answer
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
  // #starter
  // // Try each candidate on a copy, every second in a thread of its own.
  // return {};
  // #wrong half-and-half: each candidate has an outcome
  // const std::size_t half = candidates.size() / 2;
  // std::vector<Crate> outcomes(candidates.size());
  // const auto work = [&](std::size_t first) {
  //   const Data copy = make_data(model);
  //   for (std::size_t k = first; k < first + half; ++k) {
  //     mj_copyData(copy, model, now);
  //     outcomes[k] = go_on(model, copy, candidates[k]);
  //   }
  // };
  // { const std::jthread left(work, 0), right(work, half); }
  // return outcomes;
  // #wrong copied-once: an outcome does not depend on the others
  // std::vector<Crate> outcomes(candidates.size());
  // const auto work = [&](std::size_t first) {
  //   const Data copy = make_data(model);
  //   mj_copyData(copy, model, now);
  //   for (std::size_t k = first; k < candidates.size(); k += 2)
  //     outcomes[k] = go_on(model, copy, candidates[k]);
  // };
  // { const std::jthread even(work, 0), odd(work, 1); }
  // return outcomes;
  // #wrong one-thread: two threads share the work
  // std::vector<Crate> outcomes;
  // const Data copy = make_data(model);
  // for (const double candidate : candidates) {
  //   mj_copyData(copy, model, now);
  //   outcomes.push_back(go_on(model, copy, candidate));
  // }
  // return outcomes;
  // #wrong pose-and-velocity: the crate gets where it was foreseen
  // std::vector<Crate> outcomes;
  // for (const double candidate : candidates) {
  //   const Data copy = make_data(model);
  //   mju_copy(copy->qpos, now->qpos, model->nq);
  //   mju_copy(copy->qvel, now->qvel, model->nv);
  //   mju_copy(copy->ctrl, now->ctrl, model->nu);
  //   outcomes.push_back(go_on(model, copy, candidate));
  // }
  // return outcomes;
  // #endregion
}

int main() {
  const Model model = load_model("arm_and_crate");
  const Data data = make_data(model);
  ctrl(model, data) << 1.4, 1.8;  // rad, for shoulder and elbow
  for (int step = 0; step < 250; ++step) mj_step(model, data);

  std::vector<double> candidates;
  for (int k = 0; k < 16; ++k) candidates.push_back(0.1 * k);
  const std::vector<Crate> all = foresee(model, data, candidates);
  // Three of them again, in another order.
  const std::vector<Crate> few =
      foresee(model, data, {candidates[12], candidates[4], candidates[8]});
  const std::size_t used = threads.size();
  if (!expect(!all.empty() && !few.empty(), "something is foreseen",
              "foresee returns no outcome at all"))
    return 0;
  const auto is_tried = [](const Crate& crate) { return crate.x != 0; };
  if (!expect(all.size() == 16 && few.size() == 3 &&
                  std::ranges::all_of(all, is_tried) &&
                  std::ranges::all_of(few, is_tried),
              "each candidate has an outcome",
              "one is left out, if only where their number is odd"))
    return 0;

  std::vector<double> reached, tilt;
  for (const Crate& crate : all) {
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

  if (!expect(
          few[0].x == all[12].x && few[1].x == all[4].x && few[2].x == all[8].x,
          "an outcome does not depend on the others",
          "a candidate begins where another one ended") ||
      !expect(came == *best,
              "the crate gets where it was foreseen, in every bit",
              "something of the state is not in the copy"))
    return 0;
  expect(used >= 2, "two threads share the work",
         "one and the same thread tried all candidates");
}
