// Lesson 3.1, challenge: a controller with an integral, for a motor that is
// limited.
//
// INPUT    servo_arm.xml, its servo off, its motor limited to 10 N m; a load
//          that the controller does not know
// PROCESS  hold the arm down for three seconds while the controller pulls; let
//          it go; do the same from above
// OUTPUT   overshoot and error; for the lesson, the table "windup"
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l3_1_windup

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <mjcourse/mjcourse.hpp>
#include <string>
#include <vector>

using namespace mjcourse;

constexpr double kProportional = 50, kIntegral = 150;  // N m/rad, N m/(rad s)

// The torque (N m) for the error (rad) of this step. `sum` is the integral's
// torque (N m), and yours to keep from step to step. The motor can exert
// `limit` at most, either way; dt is the time step (s).
double controller(double error, double& sum, double limit, double dt) {
  // #region answer
  const double torque = kProportional * error + sum;
  const bool limited = std::abs(torque) > limit;
  const bool further = torque * error > 0;  // it would grow beyond
  if (!(limited && further)) sum += kIntegral * error * dt;
  return torque;
  // #starter
  // sum += 0;  // what does the error add up to?
  // return kProportional * error + sum;
  // #wrong adds-without-end: let go from below
  // sum += kIntegral * error * dt;
  // return kProportional * error + sum;
  // #wrong forgets-the-time-step: an unknown load
  // const double torque = kProportional * error + sum;
  // if (std::abs(torque) < limit) sum += kIntegral * error;
  // return torque;
  // #wrong looks-one-way-only: let go from above
  // const double torque = kProportional * error + sum;
  // if (torque < limit) sum += kIntegral * error * dt;
  // return torque;
  // #endregion
}

struct Swing {
  double error, overshoot;  // rad
  std::vector<double> time, angle, sum;
};

// `held` at an angle for some seconds, and then let go for six.
template <typename Law>
Swing swing(double load, double held, double seconds, double wanted, Law law) {
  const Model model = load_model("servo_arm");
  model->actuator_gainprm[0] = model->actuator_biasprm[1] = 0;
  model->actuator_forcelimited[1] = 1;
  const double limit = 10;  // N m
  model->actuator_forcerange[2] = -limit;
  model->actuator_forcerange[3] = limit;
  model->body_mass[id_of(model, mjOBJ_BODY, "load")] = load;
  const Data data = make_data(model);
  data->qpos[0] = held;
  Swing found{0, 0, {}, {}, {}};
  const double side = wanted > held ? 1 : -1;
  double sum = 0;
  const int steps = std::lround((seconds + 6) / model->opt.timestep);
  for (int step = 0; step < steps; ++step) {
    const double error = wanted - data->qpos[0];
    data->ctrl[1] = law(error, sum, limit, model->opt.timestep);
    if (step % 20 == 0) {
      found.time.push_back(data->time);
      found.angle.push_back(data->qpos[0]);
      found.sum.push_back(sum);
    }
    mj_step(model, data);
    if (data->time < seconds) {  // by a hand that does not give way
      data->qpos[0] = held;
      data->qvel[0] = 0;
    }
    found.overshoot =
        std::max(found.overshoot, side * (data->qpos[0] - wanted));
    found.error = wanted - data->qpos[0];
  }
  return found;
}

double endless(double error, double& sum, double, double dt) {
  sum += kIntegral * error * dt;
  return kProportional * error + sum;
}

double clamped(double error, double& sum, double limit, double dt) {
  sum = std::clamp(sum + kIntegral * error * dt, -limit, limit);
  return kProportional * error + sum;
}

int main() {
  std::printf("held down for 3 s      overshoot  error after 6 s (rad)\n");
  const auto report = [](const char* name, const char* key, const Swing& s) {
    std::printf("%-22s %9.3f  %.6f\n", name, s.overshoot, std::abs(s.error));
    result(std::string(key) + "_overshoot", s.overshoot);
    result(std::string(key) + "_most",
           *std::max_element(s.sum.begin(), s.sum.end()));
    result(std::string(key) + "_error", std::abs(s.error));
  };
  const Swing plain = swing(0.5, -0.3, 3, 0.2, endless);
  const Swing yours = swing(0.5, -0.3, 3, 0.2, controller);
  report("adds without end", "endless", plain);
  report("clamps its sum", "clamped", swing(0.5, -0.3, 3, 0.2, clamped));
  report("stops at the limit", "stops", yours);
  table("windup", {{"time", plain.time},
                   {"endless", plain.angle},
                   {"stops", yours.angle},
                   {"endless sum", plain.sum},
                   {"stops sum", yours.sum}});

  for (const double load : {0.0, 0.5, 0.9})
    if (!expect_near(
            swing(load, 0, 0, 0.2, controller).error, 0, 0.001,
            "an unknown load is held at the target",
            "the sum grows by kIntegral error dt in each step, as long "
            "as there is an error"))
      return 0;
  if (!expect(yours.overshoot < 0.2, "let go from below, it overshoots little",
              "while the motor is at its limit, more sum pulls no harder, and "
              "has to be worked off later"))
    return 0;
  expect(swing(0, 0.7, 3, 0.2, controller).overshoot < 0.2,
         "let go from above, it overshoots little",
         "a torque has two signs, and the motor a limit for each");
}
