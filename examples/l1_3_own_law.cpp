// Lesson 1.3: which forces the implicit integrator takes implicitly, and which
// it does not.
//
// INPUT    flywheel.xml; three carts that one damped tendon joins
// PROCESS  brake by the same law with h k / I = 5, beyond the limit of
//          Euler: as joint damping, as MuJoCo's servo, as a program's own
//          control, and as damping of a tendon across branches
// OUTPUT   the speed after one, two, three and ten steps, over that at first
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l1_3_own_law

#include <cmath>
#include <cstdio>
#include <mjcourse/mjcourse.hpp>

using namespace mjcourse;

constexpr double kGain = 5;  // N m s/rad, for 0.01 kg m^2 and steps of 10 ms

// #region pair
// MuJoCo's servo: the gain is in the model.
void servo(const Model& model, const Data&) {
  const int id = id_of(model, mjOBJ_ACTUATOR, "servo");
  model->actuator_gainprm[mjNGAIN * id] = kGain;
  model->actuator_biasprm[mjNBIAS * id + 2] = -kGain;
}

// The same law, by a program, with the current speed.
void own_law(const Model&, const Data& data) {
  data->ctrl[0] = -kGain * data->qvel[0];
}
// #endregion

void damping(const Model& model, const Data&) {
  model->dof_damping[0] = kGain;
}

// Three carts on rails of their own; the tendon's length is the sum of their
// positions, and its damping acts on the sum of their speeds.
Model three_carts() {
  return load_model_xml(R"(
    <mujoco>
      <option timestep="0.01" gravity="0 0 0"><flag contact="disable"/></option>
      <worldbody>
        <body><joint name="a" type="slide"/><geom size="0.1" mass="0.01"/></body>
        <body><joint name="b" type="slide"/><geom size="0.1" mass="0.01"/></body>
        <body><joint name="c" type="slide"/><geom size="0.1" mass="0.01"/></body>
      </worldbody>
      <tendon>
        <fixed damping="5">
          <joint joint="a" coef="1"/>
          <joint joint="b" coef="1"/>
          <joint joint="c" coef="1"/>
        </fixed>
      </tendon>
    </mujoco>)");
}

template <typename Brake>
void follow(const char* name, const char* key, const Model& model,
            Brake brake) {
  model->opt.integrator = mjINT_IMPLICIT;
  const Data data = make_data(model);
  qvel(model, data).setConstant(0.001);
  brake(model, data);  // settings of the model, from the start
  std::printf("%-26s", name);
  for (int step = 1; step <= 10; ++step) {
    mj_step1(model, data);
    brake(model, data);
    mj_step2(model, data);
    if (step <= 3 || step == 10) std::printf(" %9.2g", data->qvel[0] / 0.001);
  }
  std::printf("\n");
  result(key, std::abs(data->qvel[0] / 0.001));
}

int main() {
  std::printf(
      "implicit, after steps              1         2         3        10\n");
  follow("joint damping", "damping", load_model("flywheel"), damping);
  follow("MuJoCo's servo", "servo", load_model("flywheel"), servo);
  follow("the same law, by ctrl", "own", load_model("flywheel"), own_law);
  follow("a tendon over three carts", "tendon", three_carts(),
         [](const Model&, const Data&) {});  // it is in the model
}
