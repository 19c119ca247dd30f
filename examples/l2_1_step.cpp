// Lesson 2.1: how long a step may be, for an armature.
//
// INPUT    screwdriver.xml; the servo of its tool pulls with 125 N m/rad
// PROCESS  a step from (1, 0) and one from (0, 1) are the columns of the step's
//          matrix; seek, by halving, the time step at which its largest
//          eigenvalue leaves the unit circle
// OUTPUT   the longest time step for each armature, measured and by formula;
//          for the lesson, the table "steps"
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l2_1_step

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdio>
#include <mjcourse/mjcourse.hpp>
#include <vector>

using namespace mjcourse;

constexpr double kInertia = 1e-4, kStiffness = 125;  // kg m^2, N m/rad

// How large the largest eigenvalue of the tool's step is, as in lesson 1.3.
double growth(const Model& model, int tool) {
  const double small = 1e-6;  // rad and rad/s: the force stays in its range
  Eigen::Matrix2d step;
  for (int column = 0; column < 2; ++column) {
    const Data data = make_data(model);
    (column == 0 ? data->qpos : data->qvel)[tool] = small;
    mj_step(model, data);
    step.col(column) << data->qpos[tool] / small, data->qvel[tool] / small;
  }
  const double half = step.trace() / 2;
  const std::complex<double> square = half * half - step.determinant();
  const std::complex<double> root = std::sqrt(square);
  return std::max(std::abs(half + root), std::abs(half - root));
}

// #region longest
// The longest time step, in s, with which nothing grows.
double longest_step(const Model& model, double armature) {
  const int tool = id_of(model, mjOBJ_JOINT, "tool");
  model->dof_armature[tool] = armature;
  double calm = 1e-4, wild = 1;
  while (wild - calm > 1e-7 * calm) {
    model->opt.timestep = (calm + wild) / 2;
    const bool grows = growth(model, tool) > 1 + 1e-6;
    (grows ? wild : calm) = model->opt.timestep;
  }
  return calm;
}
// #endregion

double formula(double armature) {
  return 2 * std::sqrt((kInertia + armature) / kStiffness);
}

int main() {
  const Model model = load_model("screwdriver");
  std::printf("armature (kg m^2)  longest step (ms)  formula (ms)\n");
  for (const double armature : {0.0, 2.5e-5, 1e-4, 2.5e-3}) {
    const double found = longest_step(model, armature);
    std::printf("%17.6f  %17.3f  %12.3f\n", armature, 1000 * found,
                1000 * formula(armature));
  }
  result("bare", 1000 * longest_step(model, 0));
  result("with_rotor", 1000 * longest_step(model, 2.5e-3));

  std::vector<double> armatures, measured, predicted;
  for (int i = 0; i <= 24; ++i) {
    const double armature = 1e-6 * std::pow(10, i / 6.0);  // to 0.01
    armatures.push_back(armature);
    measured.push_back(1000 * longest_step(model, armature));
    predicted.push_back(1000 * formula(armature));
  }
  table("steps", {{"armature", armatures},
                  {"measured", measured},
                  {"formula", predicted}});
}
