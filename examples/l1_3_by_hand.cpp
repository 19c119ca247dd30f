// Lesson 1.3: mj_step by hand, and in two halves.
//
// INPUT    arm_and_crate.xml; the arm swings at the crate
// PROCESS  simulate two seconds by mj_step; by the functions that it calls, one
//          after the other; and by mj_step1 and mj_step2. Compare all bits
// OUTPUT   whether state, sensors and warm start are the same
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l1_3_by_hand

#include <cstdio>
#include <cstring>
#include <mjcourse/mjcourse.hpp>

using namespace mjcourse;
using Eigen::VectorXd;

void step_by_hand(const mjModel* model, mjData* data) {
  mj_fwdPosition(model, data);  // where is everything? needs qpos
  mj_sensorPos(model, data);
  mj_fwdVelocity(model, data);  // how fast is everything? needs qvel, too
  mj_sensorVel(model, data);
  // ---- the middle: mj_step1 ends here, and mj_step2 begins ----
  mj_fwdActuation(model, data);     // what do the actuators do? needs ctrl, act
  mj_fwdAcceleration(model, data);  // all smooth forces, and what they cause
  mj_fwdConstraint(model, data);    // contacts, limits, friction: qacc
  mj_sensorAcc(model, data);
  mj_Euler(model, data);  // only now something moves
}

void in_two_halves(const mjModel* model, mjData* data) {
  mj_step1(model, data);
  mj_step2(model, data);
}

// The numbers from which a simulation continues, and its sensors.
VectorXd after_two_seconds(const mjModel* model,
                           void (*step)(const mjModel*, mjData*)) {
  const Data data = make_data(model);
  ctrl(model, data) << 1.4, 1.8;
  while (data->time < 2) step(model, data);
  VectorXd all(1 + model->nq + 2 * model->nv + model->na + model->nsensordata);
  all << data->time, qpos(model, data), qvel(model, data),
      VectorXd::Map(data->act, model->na),
      VectorXd::Map(data->qacc_warmstart, model->nv),
      VectorXd::Map(data->sensordata, model->nsensordata);
  return all;
}

void compare(const char* label, const VectorXd& a, const VectorXd& b) {
  const bool same = std::memcmp(a.data(), b.data(), 8 * a.size()) == 0;
  std::printf("%-24s %s\n", label, same ? "the same bits" : "other bits");
}

int main() {
  const Model model = load_model("arm_and_crate");
  const VectorXd whole = after_two_seconds(model, mj_step);
  compare("stage by stage:", whole, after_two_seconds(model, step_by_hand));
  compare("mj_step1 and mj_step2:", whole,
          after_two_seconds(model, in_two_halves));
  result("numbers", static_cast<double>(whole.size()));
}
