// Lesson 2.1, exercise: the least armature with which a joint is calm.
//
// INPUT    flywheel.xml, with other inertias, springs, dampings and time steps
// PROCESS  seek, by halving, the armature at which the largest eigenvalue of a
//          step's matrix enters the unit circle; work the same out
// OUTPUT   both; checks them, on joints that need an armature and on one that
//          does not
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l2_1_least_armature

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdio>
#include <mjcourse/mjcourse.hpp>

using namespace mjcourse;

// The least armature (kg m^2) with which Euler's step of h seconds is stable,
// for a joint that moves this inertia, with a spring or servo of this
// stiffness (N m/rad) and with joint damping (N m s/rad). Never negative.
double least_armature(double inertia, double stiffness, double damping,
                      double h) {
  // #region answer
  // Trace -(1 + determinant) is the limit; damping acts at the new velocity.
  const double needed = h * h * stiffness / 4 - h * damping / 2;
  return std::max(0.0, needed - inertia);
  // #starter
  // return inertia * stiffness * damping * h;  // begin with h w <= 2
  // #wrong forgets-the-damping: with joint damping
  // return std::max(0.0, h * h * stiffness / 4 - inertia);
  // #wrong forgets-the-link: without damping
  // return std::max(0.0, h * h * stiffness / 4 - h * damping / 2);
  // #wrong stops-at-one: without damping
  // return std::max(0.0, h * h * stiffness - h * damping / 2 - inertia);
  // #wrong damps-at-the-old-velocity: with joint damping
  // return std::max(0.0, h * h * stiffness / 4 + h * damping / 2 - inertia);
  // #wrong goes-below-zero: a joint that is calm by itself
  // return h * h * stiffness / 4 - h * damping / 2 - inertia;
  // #endregion
}

// How large the largest eigenvalue of a step's matrix is.
double growth(const Model& model) {
  Eigen::Matrix2d step;
  for (int column = 0; column < 2; ++column) {
    const Data data = make_data(model);
    (column == 0 ? data->qpos : data->qvel)[0] = 1;
    mj_step(model, data);
    step.col(column) << data->qpos[0], data->qvel[0];
  }
  const double half = step.trace() / 2;
  const std::complex<double> square = half * half - step.determinant();
  const std::complex<double> root = std::sqrt(square);
  return std::max(std::abs(half + root), std::abs(half - root));
}

double measure(double inertia, double stiffness, double damping, double h) {
  const Model model = load_model("flywheel");
  const int wheel = id_of(model, mjOBJ_BODY, "wheel");
  Eigen::Map<Eigen::Vector3d>(model->body_inertia + 3 * wheel).fill(inertia);
  model->jnt_stiffness[0] = stiffness;
  model->dof_damping[0] = damping;
  model->opt.timestep = h;
  double wild = 0, calm = 10;
  if (growth(model) <= 1 + 1e-6) return 0;
  while (calm - wild > 1e-9) {
    model->dof_armature[0] = (calm + wild) / 2;
    (growth(model) <= 1 + 1e-6 ? calm : wild) = model->dof_armature[0];
  }
  return calm;
}

bool agrees(double inertia, double stiffness, double damping, double h,
            const char* what, const char* meaning) {
  const double found = measure(inertia, stiffness, damping, h);
  const double given = least_armature(inertia, stiffness, damping, h);
  std::printf("%8.4f %9.0f %8.2f %6.0f  %9.6f  %8.6f\n", inertia, stiffness,
              damping, 1000 * h, found, given);
  return expect_near(given, found, 1e-6, what, meaning);
}

int main() {
  std::printf("                                   least armature\n");
  std::printf(" inertia stiffness  damping h (ms)   measured  worked out\n");
  const char* bare = "without damping, it is the armature that MuJoCo needs";
  const char* meaning =
      "the joint's own inertia counts as well, and h w may be up to 2";
  if (!agrees(0.0001, 125, 0, 0.002, bare, meaning)) return 0;
  agrees(0.01, 4000, 0, 0.005, bare, meaning);
  const char* damped = "with joint damping, it is less";
  const char* late =
      "Euler takes joint damping at the new velocity: find the trace and the "
      "determinant of the step's matrix";
  agrees(0.0001, 125, 0.02, 0.004, damped, late);
  agrees(0.001, 4000, 1, 0.005, damped, late);
  agrees(0.01, 125, 0.1, 0.002, "a joint that is calm by itself needs none",
         "an armature is never negative");
}
