// Lesson 2.1: a rotor behind a gear, and the number that stands for it.
//
// INPUT    geared_links.xml, three links with an armature each; a link and a
//          rotor as two bodies, which a constraint gears by 1, 10 and 100
// PROCESS  let all of them fall from level for 0.4 s
// OUTPUT   how far each has fallen, and how far its rotor has turned
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l2_1_rotor

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <mjcourse/mjcourse.hpp>
#include <string>

using namespace mjcourse;

// #region train
// The link, and the rotor as a body of its own: no armature anywhere.
Model gear_train(int gear) {
  return load_model_xml(R"(
    <mujoco>
      <option timestep="0.002"><flag contact="disable"/></option>
      <worldbody>
        <body>
          <joint name="link" axis="0 -1 0"/>
          <inertial pos="0.125 0 0" mass="0.48"
                    diaginertia="0.00001 0.0025 0.0025"/>
        </body>
        <body>
          <joint name="rotor" axis="0 -1 0"/>
          <geom type="cylinder" fromto="0 0.1 0 0 0.103 0" size="0.04"
                mass="0.125"/>
        </body>
      </worldbody>
      <equality>
        <joint joint1="rotor" joint2="link" polycoef="0 )" +
                        std::to_string(gear) + R"( 0 0 0"
               solimp="0.9999 0.9999 0.001"/>
      </equality>
    </mujoco>)");
}
// #endregion

int main() {
  const Model links = load_model("geared_links");
  const Data data = make_data(links);
  const double degree = M_PI / 180;
  std::printf("        n^2 J     fallen after 0.4 s      rotor's turn\n");
  std::printf("gear  (kg m^2)  as a body  as armature     over link's\n");
  double apart = 0;  // degrees
  for (int i = 0; i < 3; ++i) {
    const int gear = std::lround(links->actuator_gear[6 * i]);
    const Model train = gear_train(gear);
    const Data real = make_data(train);
    mj_resetData(links, data);
    for (int step = 0; step < 200; ++step) {
      mj_step(links, data);
      mj_step(train, real);
      apart = std::max(apart, std::abs(real->qpos[0] - data->qpos[i]) / degree);
    }
    const double body = -real->qpos[0] / degree;
    const double armature = -data->qpos[i] / degree;
    std::printf("%4d  %8.4f  %7.2f deg  %7.2f deg  %12.3f\n", gear,
                links->dof_armature[i], body, armature,
                real->qpos[1] / real->qpos[0]);
    result("fallen_" + std::to_string(gear), armature);
    if (gear == 100) {
      const double inertia = train->dof_M0[1];  // the rotor's, about its axle
      const double link = links->dof_M0[i] - links->dof_armature[i];
      result("rotor_mass", train->body_mass[2]);
      result("rotor_grams", 1000 * train->body_mass[2]);
      result("rotor_inertia", inertia);
      result("outweighs", gear * gear * inertia / link);
    }
  }
  std::printf("never more than 0.001 degrees apart: %s\n",
              apart < 0.001 ? "yes" : "no");
}
