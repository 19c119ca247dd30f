// Lesson 1.3: where each integrator blows up.
//
// INPUT    flywheel.xml with a spring, with damping, or with a servo's brake
// PROCESS  a step from (1, 0) and one from (0, 1) are the columns of the step's
//          matrix; seek, by halving, the stiffness at which its largest
//          eigenvalue leaves the unit circle
// OUTPUT   the limits, without unit; how much energy a spring keeps
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l1_3_limits

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdio>
#include <mjcourse/mjcourse.hpp>
#include <string>

using namespace mjcourse;

constexpr double kInertia = 0.01;  // kg m^2
enum Kind { kSpring, kDamping, kServo };

// Gives the wheel a force of this kind. `stiffness` has no unit: h w for a
// spring of angular frequency w, h b / I for damping or a servo's gain b.
void give(const Model& model, Kind kind, double stiffness) {
  const double rate = stiffness / model->opt.timestep;  // 1/s
  const double spring = kind == kSpring ? kInertia * rate * rate : 0;
  const double servo = kind == kServo ? kInertia * rate : 0;
  model->jnt_stiffness[0] = spring;
  model->dof_damping[0] = kind == kDamping ? kInertia * rate : 0;
  const int id = id_of(model, mjOBJ_ACTUATOR, "servo");
  model->actuator_gainprm[mjNGAIN * id] = servo;
  model->actuator_biasprm[mjNBIAS * id + 2] = -servo;
}

// #region growth
// How large the largest eigenvalue of a step's matrix is.
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
// #endregion

double limit(const Model& model, Kind kind) {
  double calm = 0.1, wild = 1e6;
  while (wild - calm > 1e-6 * calm) {
    const double stiffness = std::sqrt(calm * wild);
    give(model, kind, stiffness);
    (growth(model) > 1 + 1e-6 ? wild : calm) = stiffness;
  }
  return calm;
}

int main() {
  const Model model = load_model("flywheel");
  std::printf("         spring damping servo  energy kept\n");
  for (const auto& [integrator, name] :
       {std::pair{mjINT_EULER, "Euler"}, std::pair{mjINT_RK4, "RK4"},
        std::pair{mjINT_IMPLICIT, "implicit"}}) {
    model->opt.integrator = integrator;
    std::printf("%-8s", name);
    for (const Kind kind : {kSpring, kDamping, kServo}) {
      const double found = limit(model, kind);
      if (found < 9e5)
        std::printf(" %6.3f", found);
      else
        std::printf("   none");
      const char* kinds[] = {"spring", "damping", "servo"};
      if (found < 9e5) result(std::string(name) + "_" + kinds[kind], found);
    }
    give(model, kSpring, 0.5);
    const double swings = 100, steps = swings * 2 * M_PI / 0.5;
    const double kept = 100 * std::pow(growth(model), 2 * steps);
    std::printf("  %5.1f %%\n", kept);
    result(std::string(name) + "_kept", kept);
  }
}
