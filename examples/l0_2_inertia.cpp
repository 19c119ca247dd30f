// Lesson 0.2: a mass and an inertia by hand, and by the compiler.
//
// INPUT    scales.xml, its body `left`: a box, a knob, a string without mass
// PROCESS  density times volume, the centre of mass, and the moments of inertia
//          about it, from the numbers in the file; the same out of the mjModel
// OUTPUT   both; exits with 1 where they differ by more than 1e-12
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l0_2_inertia

#include <cmath>
#include <cstdio>
#include <mjcourse/mjcourse.hpp>

using namespace mjcourse;
using Eigen::Map, Eigen::Matrix3d, Eigen::Quaterniond, Eigen::Vector3d;

// #region hand
// About a point that is `d` away from where it is `inertia`.
Matrix3d moved(const Matrix3d& inertia, double mass, const Vector3d& d) {
  return inertia +
         mass * (d.squaredNorm() * Matrix3d::Identity() - d * d.transpose());
}

struct Body {
  double mass;
  Vector3d centre;
  Matrix3d inertia;  // about the centre, along the axes of the body frame
};

Body left_by_hand() {
  const double a = 0.05, b = 0.04, c = 0.03, radius = 0.015;  // m
  const double box = 1000 * (2 * a) * (2 * b) * (2 * c);      // kg
  const double knob = 0.12;                                   // kg
  const Vector3d box_at(0, 0, -0.17), knob_at(0, 0, -0.13);

  const Vector3d along_sides =
      box / 3 * Vector3d(b * b + c * c, a * a + c * c, a * a + b * b);
  const Matrix3d turn = Eigen::AngleAxisd(M_PI / 6, Vector3d::UnitZ()).matrix();
  const Matrix3d box_inertia =
      turn * along_sides.asDiagonal() * turn.transpose();
  const Matrix3d knob_inertia =
      0.4 * knob * radius * radius * Matrix3d::Identity();

  const double mass = box + knob;
  const Vector3d centre = (box * box_at + knob * knob_at) / mass;
  return {mass, centre,
          moved(box_inertia, box, centre - box_at) +
              moved(knob_inertia, knob, centre - knob_at)};
}
// #endregion

// #region model
Body left_of_the_model(const Model& model) {
  const int body = id_of(model, mjOBJ_BODY, "left");
  const double* quat = model->body_iquat + 4 * body;  // w first
  const Matrix3d axes =
      Quaterniond(quat[0], quat[1], quat[2], quat[3]).matrix();
  const Vector3d principal(model->body_inertia + 3 * body);
  return {model->body_mass[body], Vector3d(model->body_ipos + 3 * body),
          axes * principal.asDiagonal() * axes.transpose()};
}
// #endregion

void show(const char* whose, const Body& body) {
  std::printf("%s\n  mass   %.4f kg, centre of mass %s m\n", whose, body.mass,
              to_text(body.centre).c_str());
  for (int row = 0; row < 3; ++row)
    std::printf("  %s %s\n", row == 0 ? "inertia" : "       ",
                to_text(1e6 * body.inertia.row(row).transpose(), 3).c_str());
}

int main() {
  const Model model = load_model("scales");
  const Body hand = left_by_hand(), compiled = left_of_the_model(model);
  show("by hand (inertia in 1e-6 kg m^2)", hand);
  show("out of the model", compiled);
  const bool same = std::abs(hand.mass - compiled.mass) < 1e-12 &&
                    (hand.centre - compiled.centre).norm() < 1e-12 &&
                    (hand.inertia - compiled.inertia).norm() < 1e-12;
  std::printf("within 1e-12: %s\n", same ? "yes" : "no");
  result("mass", hand.mass);
  result("below", -hand.centre.z());
  return same ? 0 : 1;
}
