// Lesson 2.5: tendons over two balls, with several strands and branches.
//
// INPUT    two balls of 1 kg, each on a vertical rail
// PROCESS  compute the slopes of each tendon, by MuJoCo and by differences;
//          pull each with 10 N
// OUTPUT   the slopes, and the forces that arrive at the balls
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l2_5_branches

#include <cstdio>
#include <mjcourse/mjcourse.hpp>
#include <string>

using namespace mjcourse;

// #region tendons
const std::string tendons = R"(
  <tendon>
    <fixed name="weighted sum">
      <joint joint="left" coef="0.5"/>
      <joint joint="right" coef="-2"/>
    </fixed>
    <spatial name="one strand">
      <site site="A"/> <site site="left"/>
    </spatial>
    <spatial name="two strands">
      <site site="A"/> <site site="left"/> <site site="A"/>
    </spatial>
    <spatial name="two branches">
      <pulley divisor="2"/> <site site="A"/> <site site="left"/>
      <pulley divisor="2"/> <site site="B"/> <site site="right"/>
    </spatial>
  </tendon>)";
// #endregion

const std::string balls = R"(
  <worldbody>
    <site name="A" pos="0 0 1"/>
    <site name="B" pos="0.2 0 1"/>
    <body pos="0 0 0.5">
      <joint name="left" type="slide" axis="0 0 1"/>
      <geom size="0.03" mass="1"/>
      <site name="left"/>
    </body>
    <body pos="0.2 0 0.6">
      <joint name="right" type="slide" axis="0 0 1"/>
      <geom size="0.03" mass="1"/>
      <site name="right"/>
    </body>
  </worldbody>)";

const std::string motors = R"(
  <actuator>
    <motor tendon="weighted sum"/>
    <motor tendon="one strand"/>
    <motor tendon="two strands"/>
    <motor tendon="two branches"/>
  </actuator>)";

int main() {
  const Model model =
      load_model_xml("<mujoco>" + balls + tendons + motors + "</mujoco>");
  const Data data = make_data(model);
  std::printf(
      "                   ten_J       differences   pulled with 10 N\n");
  std::printf("                left  right    left  right     left   right\n");
  for (int i = 0; i < model->ntendon; ++i) {
    double slope[2];
    for (int joint = 0; joint < 2; ++joint) {
      double length[2];
      for (int side = 0; side < 2; ++side) {
        mj_resetData(model, data);
        data->qpos[joint] = side == 0 ? -1e-6 : 1e-6;
        mj_forward(model, data);
        length[side] = data->ten_length[i];
      }
      slope[joint] = (length[1] - length[0]) / 2e-6;
    }
    mj_resetData(model, data);
    data->ctrl[i] = -10;  // a pull is negative
    mj_forward(model, data);
    const double* J = data->ten_J + i * model->nv;
    std::printf("%-13s %6.2f %6.2f  %6.2f %6.2f  %5.0f N %5.0f N\n",
                mj_id2name(model, mjOBJ_TENDON, i), J[0], J[1], slope[0],
                slope[1], data->qfrc_actuator[0], data->qfrc_actuator[1]);
  }
}
