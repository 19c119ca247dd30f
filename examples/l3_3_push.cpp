// Lesson 3.3: the same push in all directions.
//
// INPUT    planar_arm.xml, at rest
// PROCESS  push the hand with 1 N, every 5 degrees; read its acceleration from
//          MuJoCo's sensor; compute the same from J and M
// OUTPUT   some of the accelerations; the heaviest and the lightest direction;
//          for the lesson, the table "pushes"
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l3_3_push

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <mjcourse/mjcourse.hpp>
#include <vector>

using namespace mjcourse;
using Eigen::Matrix2d, Eigen::Vector2d;

constexpr double kDegree = M_PI / 180;

// #region mobility
// Turns a force at the hand into the hand's acceleration, at rest (1/kg).
Matrix2d mobility(const Model& model, const Data& data) {
  Eigen::Matrix<double, 3, 3, Eigen::RowMajor> rows;
  mj_jacSite(model, data, rows.data(), nullptr,
             id_of(model, mjOBJ_SITE, "hand"));
  const Eigen::Matrix<double, 2, 3> J = rows.topRows<2>();  // x and y
  Eigen::Matrix3d M;
  mj_fullM(model, M.data(), data->qM);
  return J * M.ldlt().solve(J.transpose());
}

// What MuJoCo's sensor says when this force acts at the hand (N, m/s^2).
Vector2d push(const Model& model, const Data& data, const Vector2d& force) {
  const int hand = id_of(model, mjOBJ_BODY, "hand");
  const int sensor = id_of(model, mjOBJ_SENSOR, "hand_acceleration");
  data->xfrc_applied[6 * hand] = force[0];
  data->xfrc_applied[6 * hand + 1] = force[1];
  mj_forward(model, data);
  return Vector2d(data->sensordata + model->sensor_adr[sensor]);
}
// #endregion

int main() {
  const Model model = load_model("planar_arm");
  const Data data = make_data(model);
  mj_forward(model, data);
  const Matrix2d derived = mobility(model, data);

  std::printf("    push      acceleration (m/s2)             aside\n");
  std::printf(" degrees      along x      along y    size  degrees\n");
  std::vector<double> push_x, push_y, ax, ay, fx, fy, degrees, size, aside;
  double most = 0, least = 1e9, off = 0, apart = 0;
  for (int angle = 0; angle <= 360; angle += 5) {
    const Vector2d force(std::cos(angle * kDegree), std::sin(angle * kDegree));
    const Vector2d a = push(model, data, force), formula = derived * force;
    const double turned = std::acos(a.normalized().dot(force)) / kDegree;
    if (angle % 30 == 0 && angle < 180)
      std::printf("%8d %12.3f %12.3f %7.3f %8.1f\n", angle, a[0], a[1],
                  a.norm(), turned);
    most = std::max(most, a.norm());
    least = std::min(least, a.norm());
    off = std::max(off, turned);
    apart = std::max(apart, (a - formula).norm());
    if (angle == 90) result("y_aside", turned), result("y_x", a[0]);
    if (angle == 90) result("y_y", a[1]);
    if (angle == 0) result("x_x", a[0]), result("x_y", a[1]);
    if (angle == 0) result("x_aside", turned);
    push_x.push_back(force[0]), push_y.push_back(force[1]);
    ax.push_back(a[0]), ay.push_back(a[1]);
    fx.push_back(formula[0]), fy.push_back(formula[1]);
    degrees.push_back(angle), size.push_back(a.norm());
    aside.push_back(turned);
  }
  // The axes of the ellipse: eigenvectors, smallest eigenvalue first.
  const Eigen::SelfAdjointEigenSolver<Matrix2d> axes(derived);
  const Vector2d mass = axes.eigenvalues().cwiseInverse();
  for (const int i : {1, 0}) {
    const Vector2d way = axes.eigenvectors().col(i);
    const double angle = std::atan2(way[1], way[0]) / kDegree;
    std::printf("%s: %.3f kg, along %.1f degrees\n",
                i == 1 ? "lightest" : "heaviest", mass[i],
                std::fmod(angle + 180, 180));
    result(i == 1 ? "light_angle" : "heavy_angle", std::fmod(angle + 180, 180));
  }
  std::printf("ratio %.2f; sensor and formula agree: %s\n", mass[0] / mass[1],
              apart < 1e-9 ? "yes" : "no");
  result("light", mass[1]);
  result("heavy", mass[0]);
  result("ratio", mass[0] / mass[1]);
  result("off", off);
  result("arm", mj_getTotalmass(model) - 0.004);
  result("most", most), result("least", least);
  table("pushes", {{"degrees", degrees},
                   {"push_x", push_x},
                   {"push_y", push_y},
                   {"x", ax},
                   {"y", ay},
                   {"formula_x", fx},
                   {"formula_y", fy},
                   {"size", size},
                   {"aside", aside}});
}
