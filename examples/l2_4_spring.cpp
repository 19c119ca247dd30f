// Lesson 2.4, challenge: a weld with a stiffness in newtons per metre.
//
// INPUT    bodies in empty space or on a rail, each welded to a mocap body or
//          to another one
// PROCESS  write solref; pull with 100 N, and glide at 0.5 m/s; measure
// OUTPUT   stretch and lag; checks two masses, a pair, a rail and an impedance
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l2_4_spring

#include <cmath>
#include <cstdio>
#include <mjcourse/mjcourse.hpp>
#include <string>

using namespace mjcourse;

// Gives a weld a stiffness (N/m) and a damping (N s/m), whatever it holds. Its
// impedance is the same at every violation: solimp[0] is solimp[1].
void make_spring(const Model& model, int weld, double stiffness,
                 double damping) {
  mjtNum* solref = model->eq_solref + mjNREF * weld;
  const double d = model->eq_solimp[mjNIMP * weld];
  // #region answer
  // A violation p gives the force (p / R) d stiffness / d^2, and R is
  // (1 - d) / d times the inverse weight: the factors d cancel.
  const double inverse_weight =
      model->body_invweight0[2 * model->eq_obj1id[weld]] +
      model->body_invweight0[2 * model->eq_obj2id[weld]];
  solref[0] = -stiffness * (1 - d) * inverse_weight;
  solref[1] = -damping * (1 - d) * inverse_weight;
  // #starter
  // (void)d;
  // solref[0] = -stiffness;  // in 1/s^2, not in N/m
  // solref[1] = -damping;
  // #wrong forgets-the-inverse-weight: 10 kg
  // solref[0] = -stiffness * (1 - d);
  // solref[1] = -damping * (1 - d);
  // #wrong forgets-the-second-body: two bodies
  // const double inverse_weight =
  //     model->body_invweight0[2 * model->eq_obj1id[weld]];
  // solref[0] = -stiffness * (1 - d) * inverse_weight;
  // solref[1] = -damping * (1 - d) * inverse_weight;
  // #wrong takes-the-mass: on a rail
  // const auto inverse = [&](int body) {
  //   const double mass = model->body_mass[body];
  //   return model->body_mocapid[body] >= 0 ? 0 : 1 / mass;
  // };
  // const double inverse_weight = inverse(model->eq_obj1id[weld]) +
  //                               inverse(model->eq_obj2id[weld]);
  // solref[0] = -stiffness * (1 - d) * inverse_weight;
  // solref[1] = -damping * (1 - d) * inverse_weight;
  // #wrong knows-one-impedance: with an impedance of 0.8
  // (void)d;
  // const double inverse_weight =
  //     model->body_invweight0[2 * model->eq_obj1id[weld]] +
  //     model->body_invweight0[2 * model->eq_obj2id[weld]];
  // solref[0] = -stiffness * 0.5 * inverse_weight;
  // solref[1] = -damping * 0.5 * inverse_weight;
  // #wrong scales-the-stiffness-alone: it lags
  // const double inverse_weight =
  //     model->body_invweight0[2 * model->eq_obj1id[weld]] +
  //     model->body_invweight0[2 * model->eq_obj2id[weld]];
  // solref[0] = -stiffness * (1 - d) * inverse_weight;
  // solref[1] = -damping;
  // #endregion
}

// Two bodies and a weld. A second mass of 0 makes the second a mocap body.
Model pair(double first, double second, const std::string& joint,
           const std::string& impedance) {
  const auto body = [](const std::string& name, double mass,
                       const std::string& with) {
    return "<body name='" + name + "'" + (mass > 0 ? "" : " mocap='true'") +
           ">" + (mass > 0 ? with : "") +
           "<geom size='0.05' contype='0' conaffinity='0' mass='" +
           std::to_string(mass) + "'/></body>";
  };
  return load_model_xml(
      "<mujoco><option gravity='0 0 0'/><worldbody>" + body("a", first, joint) +
      body("b", second, "<freejoint/>") +
      "</worldbody><equality><weld body1='a' body2='b' solimp='" + impedance +
      " " + impedance + "'/></equality></mujoco>");
}

const std::string kFree = "<freejoint/>";
const std::string kRail = "<joint type='slide' axis='1 0 0'/>";

// How far 100 N pull the two apart (mm).
double stretch(const Model& model) {
  make_spring(model, 0, 5000, 300);
  const Data data = make_data(model);
  data->xfrc_applied[6 * 1] = 100;
  data->xfrc_applied[6 * 2] = -100;
  while (data->time < 12) mj_step(model, data);
  mj_forward(model, data);
  return 1000 * data->efc_pos[0];
}

// How far the first body is behind its target at 0.5 m/s (mm).
double lag(const Model& model) {
  make_spring(model, 0, 5000, 300);
  const Data data = make_data(model);
  for (; data->time < 3; mj_step(model, data))
    data->mocap_pos[0] = 0.5 * data->time;
  return 1000 * (0.5 * data->time - data->qpos[0]);
}

int main() {
  std::printf("a weld of 5000 N/m, pulled with 100 N\n");
  for (const double mass : {1.0, 3.0, 10.0})
    std::printf("%5.0f kg: %.3f mm\n", mass,
                stretch(pair(mass, 0, kFree, "0.5")));
  const double behind = lag(pair(1, 0, kFree, "0.5"));
  std::printf("at 0.5 m/s with 300 N s/m, 1 kg is behind by %.1f mm\n", behind);
  result("behind", behind);

  const Model loose = pair(1, 0, kFree, "0.5");
  make_spring(loose, 0, 5000, 300);
  const Data data = make_data(loose);
  data->xfrc_applied[6 * 1] = 100;
  mj_forward(loose, data);
  std::printf("100 N accelerate 1 kg by %.0f m/s^2 at first\n", data->qacc[0]);
  result("at_first", data->qacc[0]);

  const auto agrees = [](const Model& model, const char* what,
                         const char* meaning) {
    return expect_near(stretch(model), 20, 0.01, what, meaning);
  };
  if (!agrees(
          pair(1, 0, kFree, "0.5"),
          "1 kg at a mocap body stretches the weld by 20 mm",
          "a stiffness in solref is in 1/s^2: which mass turns it into N/m, "
          "and which part of it does d leave?"))
    return 0;
  if (!agrees(pair(10, 0, kFree, "0.5"), "10 kg stretch it as far",
              "the mass must cancel"))
    return 0;
  if (!agrees(pair(3, 2, kFree, "0.5"), "two bodies stretch it as far",
              "both bodies are in the sum"))
    return 0;
  if (!agrees(pair(2, 0, kRail, "0.5"), "on a rail, it stretches as far",
              "body_invweight0 is a mean over three directions, and two of "
              "them are blocked"))
    return 0;
  if (!agrees(pair(1, 0, kFree, "0.8"),
              "with an impedance of 0.8, it stretches as far",
              "d is a parameter"))
    return 0;
  expect_near(behind, 30, 0.1, "it lags by c v / k at a steady speed",
              "solref's second number is a damping over a mass, too");
}
