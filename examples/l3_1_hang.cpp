// Lesson 3.1: where a position servo comes to rest against gravity.
//
// INPUT    servo_arm.xml; the wanted angle is 0, level
// PROCESS  give the servo a gain; wait a second, ten, and a minute; solve
//          the balance of torques for the same angle
// OUTPUT   the angles; for the lesson, many gains as the table "gains"
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l3_1_hang

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <mjcourse/mjcourse.hpp>
#include <string>
#include <vector>

using namespace mjcourse;

// #region set
// A servo's gain stands in the model twice: once for ctrl, once for the angle.
void set_gain(const Model& model, int servo, double kp) {
  model->actuator_gainprm[mjNGAIN * servo] = kp;
  model->actuator_biasprm[mjNBIAS * servo + 1] = -kp;
}
// #endregion

// #region balance
// The angle at which kp (ctrl - q) = level cos q, for ctrl = 0.
double balance(double level, double kp) {
  double low = -M_PI / 2, high = 0;
  while (high - low > 1e-12) {
    const double q = (low + high) / 2;
    (kp * (0 - q) > level * std::cos(q) ? low : high) = q;
  }
  return low;
}
// #endregion

int main() {
  const Model model = load_model("servo_arm");
  const int servo = id_of(model, mjOBJ_ACTUATOR, "servo");
  const Data level = make_data(model);
  mj_forward(model, level);
  const double weight = level->qfrc_bias[0];  // N m, with the arm level

  std::printf("angle (rad)   after 1 s    10 s       60 s       balance\n");
  std::vector<double> gains, sags, simple;
  double apart = 0;
  for (double kp = 25; kp < 4000; kp *= 2) {
    set_gain(model, servo, kp);
    const Data data = make_data(model);
    const auto after = [&](double seconds) {
      while (data->time < seconds) mj_step(model, data);
      return data->qpos[0];
    };
    const double early = after(1), late = after(10);
    const double predicted = balance(weight, kp);
    if (kp < 300) {
      const double last = after(60);
      std::printf("kp = %3.0f      %9.6f  %9.6f  %9.6f  %9.6f\n", kp, early,
                  late, last, predicted);
      const std::string name = std::to_string(std::lround(kp));
      result("soon_" + name, -late);
      result("sag_" + name, -last);
      result("simple_" + name, weight / kp);
    }
    apart = std::max(apart, std::abs(late - predicted));
    gains.push_back(kp);
    sags.push_back(-late);
    simple.push_back(weight / kp);
  }
  std::printf("all %zu gains, after 10 s: within 1e-6 rad: %s\n", gains.size(),
              apart < 1e-6 ? "yes" : "no");
  result("weight", weight);
  table("gains", {{"gain", gains}, {"sag", sags}, {"simple", simple}});
}
