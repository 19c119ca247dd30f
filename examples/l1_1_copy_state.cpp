// Lesson 1.1: what a copy of the state misses.
//
// INPUT    arm_and_crate.xml, its arm in full swing towards the crate
// PROCESS  stop after 0.2 s, copy the state in four ways into fresh data, and
//          let original and copy go on for a second
// OUTPUT   how far each copy's hand and qpos get from the original's; for the
//          lesson, the hands' distance over time as the table "apart"
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l1_1_copy_state

#include <algorithm>
#include <cstdio>
#include <mjcourse/mjcourse.hpp>
#include <vector>

using namespace mjcourse;
using Eigen::Map, Eigen::Vector3d;

// #region copies
enum What { kPositions, kActivations, kState, kEverything };

void copy(const Model& model, const Data& from, const Data& to, What what) {
  if (what == kEverything) {
    mj_copyData(to, model, from);
    return;
  }
  ctrl(model, to) = ctrl(model, from);  // an input, set by the caller
  qpos(model, to) = qpos(model, from);
  qvel(model, to) = qvel(model, from);
  if (what >= kActivations) std::copy_n(from->act, model->na, to->act);
  if (what >= kState) {
    to->time = from->time;
    std::copy_n(from->qacc_warmstart, model->nv, to->qacc_warmstart);
  }
}
// #endregion

struct Drift {
  std::vector<double> time, hand;  // s, mm
  double qpos;                     // the largest difference of any entry
};

Drift drift(const Model& model, What what) {
  const Data original = make_data(model), other = make_data(model);
  const int hand = 3 * id_of(model, mjOBJ_SITE, "hand");
  ctrl(model, original) << 1.4, 1.8;  // rad, for shoulder and elbow
  for (int step = 0; step < 100; ++step) mj_step(model, original);
  copy(model, original, other, what);

  Drift found{};
  for (int step = 0; step < 500; ++step) {
    mj_step(model, original);
    mj_step(model, other);
    const Map<const Vector3d> a(original->site_xpos + hand);
    const Map<const Vector3d> b(other->site_xpos + hand);
    found.time.push_back(original->time);
    found.hand.push_back(1000 * (a - b).norm());
    const double apart =
        (qpos(model, original) - qpos(model, other)).lpNorm<Eigen::Infinity>();
    found.qpos = std::max(found.qpos, apart);
  }
  return found;
}

int main() {
  const Model model = load_model("arm_and_crate");
  const Drift d[] = {drift(model, kPositions), drift(model, kActivations),
                     drift(model, kState), drift(model, kEverything)};
  const char* const names[] = {"qpos, qvel", "... and act",
                               "... and time, qacc_warmstart", "mj_copyData"};
  std::printf("copied                        hand apart (mm)  qpos apart\n");
  for (int k = 0; k < 4; ++k)
    std::printf("%-29s %15.1f  %s\n", names[k],
                *std::max_element(d[k].hand.begin(), d[k].hand.end()),
                d[k].qpos == 0      ? "not at all"
                : d[k].qpos < 1e-12 ? "by rounding, below 1e-12"
                                    : "far");
  result("hand_apart", *std::max_element(d[0].hand.begin(), d[0].hand.end()));
  table(
      "apart",
      {{"time", d[0].time}, {"qpos_qvel", d[0].hand}, {"and_act", d[1].hand}});
}
