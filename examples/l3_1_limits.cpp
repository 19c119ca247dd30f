// Lesson 3.1: the largest gain of a servo, by where its damping is.
//
// INPUT    servo_arm.xml without gravity, and a damping ratio
// PROCESS  a step from (1, 0) and one from (0, 1) are the columns of the step's
//          matrix; seek the k_p at which its largest eigenvalue leaves the
//          unit circle, with the damping in the joint, or in the servo's k_v
// OUTPUT   the largest gains; for the lesson, the table "limits"
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l3_1_limits

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdio>
#include <mjcourse/mjcourse.hpp>
#include <vector>

using namespace mjcourse;

enum Place { kJoint, kServo, kImplicit };
constexpr double kInertia = 0.125;  // kg m^2

// #region give
// A servo with hw = speed, and its damping ratio by joint damping or by k_v.
double give(const Model& model, Place place, double speed, double ratio) {
  const double w = speed / model->opt.timestep;  // 1/s
  const double kp = kInertia * w * w, damping = 2 * ratio * kInertia * w;
  model->actuator_gainprm[0] = kp;
  model->actuator_biasprm[1] = -kp;
  model->actuator_biasprm[2] = place == kJoint ? 0 : -damping;
  model->dof_damping[0] = place == kJoint ? damping : 0;
  model->opt.integrator = place == kImplicit ? mjINT_IMPLICIT : mjINT_EULER;
  return kp;
}
// #endregion

double growth(const Model& model) {
  const double small = 1e-6;  // the servo's force stays within its range
  Eigen::Matrix2d step;
  for (int column = 0; column < 2; ++column) {
    const Data data = make_data(model);
    (column == 0 ? data->qpos : data->qvel)[0] = small;
    mj_step(model, data);
    step.col(column) << data->qpos[0] / small, data->qvel[0] / small;
  }
  // Its eigenvalues solve x^2 - trace x + determinant = 0.
  const double half = step.trace() / 2;
  const std::complex<double> square = half * half - step.determinant();
  const std::complex<double> root = std::sqrt(square);
  return std::max(std::abs(half + root), std::abs(half - root));
}

// The largest hw at which nothing grows.
double limit(const Model& model, Place place, double ratio) {
  double calm = 0.01, wild = 100;
  while (wild - calm > 1e-6 * calm) {
    const double speed = std::sqrt(calm * wild);
    give(model, place, speed, ratio);
    (growth(model) > 1 + 1e-7 ? wild : calm) = speed;
  }
  return calm;
}

int main() {
  const Model model = load_model("servo_arm");
  model->opt.gravity[2] = 0;
  std::printf("largest hw by ratio         0    0.2      1      3\n");
  const char* names[] = {"joint damping, Euler", "k_v of the servo, Euler",
                         "k_v, implicit"};
  for (const Place place : {kJoint, kServo, kImplicit}) {
    std::printf("%-23s", names[place]);
    for (const double ratio : {0.0, 0.2, 1.0, 3.0})
      std::printf(" %6.3f", limit(model, place, ratio));
    std::puts("");
  }
  const double joint = limit(model, kJoint, 1), servo = limit(model, kServo, 1);
  const double joint_kp = give(model, kJoint, joint, 1);
  const double servo_kp = give(model, kServo, servo, 1);
  std::printf("critically damped, 2 ms: kp up to %.0f and %.0f N m/rad\n",
              joint_kp, servo_kp);
  result("joint", joint);
  result("servo", servo);
  result("joint_kp", joint_kp);
  result("servo_kp", servo_kp);
  result("times", joint_kp / servo_kp);

  std::vector<double> ratios, joints, servos, up, down;
  for (double z = 0; z < 3.05; z += 0.25) {
    ratios.push_back(z);
    joints.push_back(limit(model, kJoint, z));
    servos.push_back(limit(model, kServo, z));
    up.push_back(2 * std::sqrt(z * z + 1) + 2 * z);
    down.push_back(2 * std::sqrt(z * z + 1) - 2 * z);
  }
  table("limits", {{"ratio", ratios},
                   {"joint", joints},
                   {"servo", servos},
                   {"joint formula", up},
                   {"servo formula", down}});
}
