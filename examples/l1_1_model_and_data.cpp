// Lesson 1.1: constants in the model, everything that changes in the data.
//
// INPUT    arm_and_crate.xml: a crate on the floor, an arm with two hinges
// PROCESS  (1) print what has a name: its id, and the address of its numbers;
//          (2) write an angle into qpos, and read where the hand is before and
//              after mj_kinematics;
//          (3) take two data of one model, and change the model's gravity
// OUTPUT   ids next to addresses, three heights of the hand, and one
//          acceleration of the crate in each of the two data
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l1_1_model_and_data

#include <cstdio>
#include <mjcourse/mjcourse.hpp>

using namespace mjcourse;

void addresses(const Model& model) {
  std::printf("joint            id  qpos  qvel\n");
  for (int j = 0; j < model->njnt; ++j)
    std::printf("  %-14s %2d  %4d  %4d\n", mj_id2name(model, mjOBJ_JOINT, j), j,
                model->jnt_qposadr[j], model->jnt_dofadr[j]);
  std::printf("sensor           id  sensordata\n");
  for (int s = 0; s < model->nsensor; ++s)
    std::printf("  %-14s %2d  %2d, %d long\n",
                mj_id2name(model, mjOBJ_SENSOR, s), s, model->sensor_adr[s],
                model->sensor_dim[s]);
}

void stale_hand(const Model& model) {
  const Data data = make_data(model);
  const int elbow = model->jnt_qposadr[id_of(model, mjOBJ_JOINT, "elbow")];
  const int hand = id_of(model, mjOBJ_SITE, "hand");
  const double& height = data->site_xpos[3 * hand + 2];

  std::printf("height of the hand (m)\n");
  std::printf("  fresh data, nothing called:   %.3f\n", height);
  mj_forward(model, data);
  std::printf("  mj_forward:                   %.3f\n", height);
  result("upright", height);  // for the lesson's text to quote
  data->qpos[elbow] = 1.5;
  std::printf("  elbow bent, nothing called:   %.3f\n", height);
  mj_kinematics(model, data);
  std::printf("  mj_kinematics:                %.3f\n", height);
  result("bent", height);
}

void one_model_two_data(const Model& model) {
  const Data here = make_data(model), there = make_data(model);
  const int up = model->jnt_dofadr[id_of(model, mjOBJ_JOINT, "crate")] + 2;
  for (const Data* data : {&here, &there})
    qpos(model, *data)[model->jnt_qposadr[0] + 2] += 0.5;  // off the floor

  model->opt.gravity[2] = -1.62;  // m/s^2, the moon's; for both of them
  std::printf("acceleration of the crate in the air (m/s^2)\n");
  for (const Data* data : {&here, &there}) {
    mj_forward(model, *data);
    std::printf("  %.2f\n", qacc(model, *data)[up]);
  }
}

int main() {
  const Model model = load_model("arm_and_crate");
  addresses(model);
  stale_hand(model);
  one_model_two_data(model);
}
