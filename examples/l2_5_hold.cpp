// Lesson 2.5, exercise: the activation that holds a load.
//
// INPUT    muscle_arm.xml at several angles, at rest, both muscles relaxed
// PROCESS  work out the activation of the biceps that balances everything else
// OUTPUT   the activations; checks that nothing accelerates
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l2_5_hold

#include <cmath>
#include <cstdio>
#include <mjcourse/mjcourse.hpp>

using namespace mjcourse;

constexpr int kBiceps = 0, kTriceps = 1;

// What mju_muscleGain and mju_muscleBias say of muscle i, for its length and
// velocity in `data`: the force for an activation of 1, and that for none.
double gain(const mjModel* model, const mjData* data, int i) {
  return mju_muscleGain(data->actuator_length[i], data->actuator_velocity[i],
                        model->actuator_lengthrange + 2 * i,
                        model->actuator_acc0[i],
                        model->actuator_gainprm + mjNGAIN * i);
}
double bias(const mjModel* model, const mjData* data, int i) {
  return mju_muscleBias(
      data->actuator_length[i], model->actuator_lengthrange + 2 * i,
      model->actuator_acc0[i], model->actuator_biasprm + mjNBIAS * i);
}

// The activation of the biceps with which the elbow does not accelerate. The
// triceps is relaxed, mj_forward has been called, and nothing moves.
double activation(const mjModel* model, const mjData* data) {
  // #region answer
  // bias force = arm (a gain + bias) of the biceps + arm bias of the triceps
  const double* arm = data->actuator_moment;  // one joint: a number a muscle
  const double passive = arm[kBiceps] * bias(model, data, kBiceps) +
                         arm[kTriceps] * bias(model, data, kTriceps);
  return (data->qfrc_bias[0] - passive) /
         (arm[kBiceps] * gain(model, data, kBiceps));
  // #starter
  // const double* arm = data->actuator_moment;  // one joint: a number a muscle
  // const double needed = data->qfrc_bias[0];   // against gravity, in N m
  // return 0 * arm[kBiceps] * needed;
  // #wrong forgets-the-passive-force: where the biceps is stretched
  // const double* arm = data->actuator_moment;
  // const double passive = arm[kTriceps] * bias(model, data, kTriceps);
  // return (data->qfrc_bias[0] - passive) /
  //        (arm[kBiceps] * gain(model, data, kBiceps));
  // #wrong forgets-the-other-muscle: where the triceps is stretched
  // const double* arm = data->actuator_moment;
  // const double passive = arm[kBiceps] * bias(model, data, kBiceps);
  // return (data->qfrc_bias[0] - passive) /
  //        (arm[kBiceps] * gain(model, data, kBiceps));
  // #wrong takes-torque-for-force: at 60 and 90 degrees
  // return data->qfrc_bias[0] / -gain(model, data, kBiceps);
  // #wrong takes-the-peak-force: at 60 and 90 degrees
  // const double peak = model->actuator_gainprm[2];
  // return data->qfrc_bias[0] / (-data->actuator_moment[kBiceps] * peak);
  // #wrong pushes: at 60 and 90 degrees
  // return data->qfrc_bias[0] /
  //        (-data->actuator_moment[kBiceps] * gain(model, data, kBiceps));
  // #endregion
}

int main() {
  const Model model = load_model("muscle_arm");
  const Data data = make_data(model);
  const auto answer = [&](int degrees) {
    mj_resetData(model, data);
    data->qpos[0] = degrees * M_PI / 180;
    mj_forward(model, data);
    const double act = activation(model, data);
    data->act[kBiceps] = data->ctrl[kBiceps] = act;
    mj_forward(model, data);
    std::printf("%3d degrees: activation %7.3f, qacc %6.3f rad/s2\n", degrees,
                act, data->qacc[0] + 0.);
    result("at_" + std::to_string(degrees), act);
    return std::abs(data->qacc[0]);
  };
  const char* free = "at 60 and 90 degrees, nothing accelerates";
  const char* meaning =
      "the torque of the biceps, arm times force, has to be the bias force; "
      "its force is activation times gain";
  if (!expect_near(answer(60), 0, 1e-9, free, meaning)) return 0;
  for (int step = 0; step < 1000; ++step) mj_step(model, data);
  std::printf("two seconds later:  %.2f degrees\n", data->qpos[0] * 180 / M_PI);
  expect_near(answer(90), 0, 1e-9, free, meaning);
  expect_near(answer(20), 0, 1e-9,
              "where the biceps is stretched, nothing accelerates",
              "beyond its best length, a muscle pulls without any activation");
  expect_near(answer(130), 0, 1e-9,
              "where the triceps is stretched, nothing accelerates",
              "a relaxed muscle pulls, too, where it is long");
}
