// Lesson 2.4: how a hand follows a mocap body.
//
// INPUT    mocap_hands.xml: 1 kg and 10 kg, each welded to a target
// PROCESS  let both targets jump by 100 mm, then glide at 0.5 m/s; compare the
//          hands with the documented formulas
// OUTPUT   how far the hands are behind; for the lesson, the jump as the table
//          "jump"
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l2_4_follow

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <mjcourse/mjcourse.hpp>
#include <vector>

using namespace mjcourse;

// Both welds get the time constant and an impedance that is always the same.
void soften(const Model& model, double time) {
  for (int weld = 0; weld < 2; ++weld) {
    model->eq_solref[mjNREF * weld] = time;
    model->eq_solimp[mjNIMP * weld] = model->eq_solimp[mjNIMP * weld + 1];
  }
}

void put_targets(const Data& data, double x) {
  data->mocap_pos[0] = data->mocap_pos[3] = x;
}

int main() {
  const Model model = load_model("mocap_hands");
  model->opt.gravity[2] = 0;
  model->opt.disableflags |= mjDSBL_CONTACT;  // the crate is in the way
  model->opt.timestep = 0.0005;
  const int light = model->jnt_qposadr[id_of(model, mjOBJ_JOINT, "light")];
  const int heavy = model->jnt_qposadr[id_of(model, mjOBJ_JOINT, "heavy")];

  // #region glide
  const double speed = 0.5;  // m/s
  std::printf("time constant (s)   1 kg (mm)  10 kg (mm)  2 T v (mm)\n");
  for (const double time : {0.02, 0.05, 0.1}) {
    soften(model, time);
    const Data data = make_data(model);
    for (; data->time < 2; mj_step(model, data))
      put_targets(data, speed * data->time);
    const double target = speed * data->time;
    std::printf("%17.2f  %10.2f  %10.2f  %10.2f\n", time,
                1000 * (target - data->qpos[light]),
                1000 * (target - data->qpos[heavy]), 1000 * 2 * time * speed);
    if (time == 0.02)
      result("lateness", 1000 * (target - data->qpos[light]) / speed);  // ms
  }
  // #endregion

  const double T = 0.1;
  soften(model, T);
  const Data data = make_data(model);
  std::vector<double> times, one, ten, formula;
  double apart = 0;
  for (int step = 0; step <= 1200; ++step, mj_step(model, data)) {
    put_targets(data, 0.1);
    const double ratio = data->time / T;
    const double x = 0.1 * (1 - (1 + ratio) * std::exp(-ratio));
    apart = std::max(apart, std::abs(data->qpos[light] - x));
    apart = std::max(apart, std::abs(data->qpos[heavy] - x));
    if (step % 60 != 0) continue;
    times.push_back(data->time);
    one.push_back(1000 * data->qpos[light]);
    ten.push_back(1000 * data->qpos[heavy]);
    formula.push_back(1000 * x);
  }
  std::printf("after a jump of 100 mm, within 0.2 mm: %s\n",
              apart < 0.0002 ? "yes" : "no");
  table("jump",
        {{"time", times}, {"1 kg", one}, {"10 kg", ten}, {"formula", formula}});
}
