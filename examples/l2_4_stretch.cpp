// Lesson 2.4: how far a weld stretches.
//
// INPUT    two bodies in empty space, held together by a weld; the second is
//          a mocap body or has a mass
// PROCESS  pull them apart, wait, read the violation; solve the documented
//          formulas for the same distance
// OUTPUT   both distances; for the lesson, many pulls as the table "pulls"
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l2_4_stretch

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <mjcourse/mjcourse.hpp>
#include <string>
#include <vector>

using namespace mjcourse;

// Two bodies and a weld. A second mass of 0 makes the second a mocap body.
Model pair(double first, double second,
           const std::string& joint = "<freejoint/>") {
  const auto body = [&](const std::string& name, double mass) {
    return "<body name='" + name + "'" + (mass > 0 ? "" : " mocap='true'") +
           ">" + (mass > 0 ? joint : "") +
           "<geom size='0.05' contype='0' conaffinity='0' mass='" +
           std::to_string(mass) + "'/></body>";
  };
  return load_model_xml("<mujoco><option gravity='0 0 0'/><worldbody>" +
                        body("a", first) + body("b", second) +
                        "</worldbody><equality><weld body1='a' body2='b'/>"
                        "</equality></mujoco>");
}

// #region formula
// The impedance d at a violation, for MuJoCo's default midpoint and power.
double impedance(const mjtNum* solimp, double violation) {
  const double x = std::min(violation / solimp[2], 1.0);
  const double y = x <= 0.5 ? 2 * x * x : 1 - 2 * (1 - x) * (1 - x);
  return solimp[0] + y * (solimp[1] - solimp[0]);
}

// The violation p at which the weld's force, (p / R) * k, equals the pull.
double stretch(const mjModel* model, double pull) {
  const mjtNum *solref = model->eq_solref, *solimp = model->eq_solimp;
  const double weight = model->body_invweight0[2 * model->eq_obj1id[0]] +
                        model->body_invweight0[2 * model->eq_obj2id[0]];
  double low = 0, high = 10;  // m; the force grows with the violation
  while (high - low > 1e-12) {
    const double p = (low + high) / 2, d = impedance(solimp, p);
    const double k = d / std::pow(solimp[1] * solref[0] * solref[1], 2);
    const double R = (1 - d) / d * weight;
    (k * p / R < pull ? low : high) = p;
  }
  return low;
}
// #endregion

// The violation after two seconds of pulling both bodies apart.
double measure(const Model& model, double pull) {
  const Data data = make_data(model);
  data->xfrc_applied[6 * 1] = pull;
  data->xfrc_applied[6 * 2] = -pull;  // a mocap body does not notice
  while (data->time < 2) mj_step(model, data);
  mj_forward(model, data);
  return data->efc_pos[0];
}

int main() {
  std::printf("pulled with 100 N       1/kg  stretch (mm)  formula (mm)\n");
  const auto show = [](const char* what, const Model& model) {
    mj_forward(model, make_data(model));
    std::printf("%-20s  %6.2f  %12.3f  %12.3f\n", what,
                model->body_invweight0[2] + model->body_invweight0[4],
                1000 * measure(model, 100), 1000 * stretch(model, 100));
  };
  show("1 kg, mocap body", pair(1, 0));
  show("10 kg, mocap body", pair(10, 0));
  show("100 kg, mocap body", pair(100, 0));
  show("1 kg and 1 kg", pair(1, 1));
  show("1 kg and 10 kg", pair(1, 10));
  show("10 kg and 10 kg", pair(10, 10));
  const char* const rail = "<joint type='slide' axis='1 0 0'/>";
  show("1 kg on a rail", pair(1, 0, rail));

  std::vector<double> masses, pulls, measured, predicted;
  double apart = 0;
  for (const double mass : {1, 10, 100}) {
    const Model model = pair(mass, 0);
    for (double pull = 1; pull < 1.1e4; pull *= std::sqrt(10)) {
      masses.push_back(mass);
      pulls.push_back(pull);
      measured.push_back(1000 * measure(model, pull));
      predicted.push_back(1000 * stretch(model, pull));
      apart = std::max(apart, std::abs(measured.back() - predicted.back()));
    }
  }
  std::printf("from 1 N to 10 kN, within 1e-5 mm: %s\n",
              apart < 1e-5 ? "yes" : "no");
  table("pulls", {{"mass", masses},
                  {"pull", pulls},
                  {"stretch", measured},
                  {"formula", predicted}});
}
