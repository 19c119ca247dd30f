// Lesson 2.5: a moment arm is the slope of a length.
//
// INPUT    muscle_arm.xml, the elbow from 0 to 140 degrees
// PROCESS  turn the elbow a little both ways, and divide the change of each
//          tendon's length by the turn; work the arm of the biceps out as well
// OUTPUT   both beside ten_J; for the lesson, the table "arms"
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l2_5_moment_arms

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <mjcourse/mjcourse.hpp>
#include <vector>

using namespace mjcourse;

// #region slope
// How fast a tendon's length grows with the elbow's angle, by differences.
double slope(const mjModel* model, mjData* data, int tendon) {
  const double angle = data->qpos[0], turn = 1e-6;
  const auto length = [&](double at) {
    data->qpos[0] = at;
    mj_fwdPosition(model, data);
    return data->ten_length[tendon];
  };
  const double change = length(angle + turn) - length(angle - turn);
  length(angle);  // everything is as it was
  return change / (2 * turn);
}
// #endregion

// #region derived
// The arm of the biceps, from the places of its two ends, in metres.
double derived(const mjModel* model, double angle) {
  const int pulley = id_of(model, mjOBJ_GEOM, "pulley");
  const int upper = id_of(model, mjOBJ_SITE, "biceps_origin");
  const int lower = id_of(model, mjOBJ_SITE, "biceps_insertion");
  const double* origin = model->site_pos + 3 * upper;     // x, y, z
  const double* insertion = model->site_pos + 3 * lower;  // in the forearm
  const double R = model->geom_size[3 * pulley];
  const double up = origin[2] - model->geom_pos[3 * pulley + 2];
  const double a = std::hypot(origin[0], up);
  const double d = std::hypot(insertion[0], insertion[2]);
  const double gamma = M_PI - std::atan2(origin[0], up) -
                       std::atan2(insertion[0], -insertion[2]) - angle;
  const double around = gamma - std::acos(R / a) - std::acos(R / d);
  if (around > 0) return R;
  const double square = a * a + d * d - 2 * a * d * std::cos(gamma);
  return a * d * std::sin(gamma) / std::sqrt(square);
}
// #endregion

int main() {
  const Model model = load_model("muscle_arm");
  const Data data = make_data(model);
  double apart = 0;
  std::vector<double> angles, biceps, formula, triceps;
  std::printf("elbow        biceps (mm)             triceps (mm)\n");
  std::printf("(deg)  -ten_J  differences  derived  -ten_J  differences\n");
  for (int angle = 0; angle <= 140; angle += 4) {
    data->qpos[0] = angle * M_PI / 180;
    const double slopes[] = {slope(model, data, 0), slope(model, data, 1)};
    angles.push_back(angle);
    biceps.push_back(-1000 * data->ten_J[0]);
    triceps.push_back(-1000 * data->ten_J[1]);
    formula.push_back(1000 * derived(model, data->qpos[0]));
    apart = std::max({apart, std::abs(1000 * slopes[0] + biceps.back()),
                      std::abs(1000 * slopes[1] + triceps.back()),
                      std::abs(formula.back() - biceps.back())});
    if (angle % 20 == 0)
      std::printf("%5d  %6.2f  %11.2f  %7.2f  %6.2f  %11.2f\n", angle,
                  biceps.back(), -1000 * slopes[0], formula.back(),
                  triceps.back(), -1000 * slopes[1]);
  }
  std::printf("never more than 1e-5 mm apart: %s\n",
              apart < 1e-5 ? "yes" : "no");
  table("arms", {{"angle", angles},
                 {"biceps", biceps},
                 {"derived", formula},
                 {"triceps", triceps}});
  result("largest", *std::max_element(biceps.begin(), biceps.end()));
}
