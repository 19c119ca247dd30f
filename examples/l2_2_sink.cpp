// Lesson 2.2: more friction makes a floor softer.
//
// INPUT    four_boxes.xml: boxes with friction 1, 2, 4 and 8, MuJoCo's defaults
// PROCESS  wait until they rest, with both friction cones; read R of an edge;
//          solve the formula of the lesson for the same depths
// OUTPUT   depths, and how many times as soft as an elliptic contact a pyramid
//          is; for the lesson, more coefficients as the table "depths"
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l2_2_sink

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <mjcourse/mjcourse.hpp>
#include <string>
#include <vector>

using namespace mjcourse;

// #region formula
// A pyramid is so many times as soft along its normal as an elliptic contact.
double softer(double friction, int condim) {
  const double square = friction * friction;
  return square * (1 + square) / (condim - 1);
}

// The depth (m) at which n contacts, each s times as soft, carry a body:
// d k p = (1 - d) a s / n, with MuJoCo's default solref and solimp.
double depth_at_rest(double a, double s, int n) {
  const double dmin = 0.9, dmax = 0.95, width = 0.001, time = 0.02;
  double low = 0, high = 10;  // m; the left side grows with the depth
  while (high - low > 1e-10) {
    const double p = (low + high) / 2, x = std::min(p / width, 1.0);
    const double y = x < 0.5 ? 2 * x * x : 1 - 2 * (1 - x) * (1 - x);
    const double d = dmin + y * (dmax - dmin);
    const double k = d / std::pow(dmax * time, 2);
    (d * k * p < (1 - d) * a * s / n ? low : high) = p;
  }
  return low;
}
// #endregion

struct Box {
  double depth, edge;  // mm; R without its (1 - d) / d, in 1/kg
};

std::vector<Box> rest(const Model& model, int cone) {
  model->opt.cone = cone;
  const Data data = make_data(model);
  while (data->time < 6) mj_step(model, data);
  mj_forward(model, data);
  std::vector<Box> boxes;
  for (int box = 0; box < 4; ++box) {  // four contacts each, one box after
    const int row = data->contact[4 * box].efc_address;  // the other
    const double d = data->efc_KBIP[4 * row + 2];
    boxes.push_back({1000 * (0.12 - data->qpos[7 * box + 2]),
                     data->efc_R[row] * d / (1 - d)});
  }
  return boxes;
}

int main() {
  const Model model = load_model("four_boxes");
  std::printf("          elliptic  pyramidal, mm         times as soft\n");
  std::printf("friction        mm  measured     formula    by R  formula\n");

  const int floor = id_of(model, mjOBJ_GEOM, "floor");
  model->geom_friction[3 * floor] = 0.1;  // so that the box's is the larger
  std::vector<double> friction, pyramidal, elliptic, formula;
  const char* names[] = {"one", "two", "four", "eight"};
  for (const double scale : {1.0, 0.84, 0.71, 0.6}) {
    for (int box = 0; box < 4; ++box)
      model->geom_friction[3 * id_of(model, mjOBJ_GEOM, names[box])] =
          scale * (1 << box);
    const std::vector<Box> e = rest(model, mjCONE_ELLIPTIC);
    const std::vector<Box> p = rest(model, mjCONE_PYRAMIDAL);
    for (int box = 0; box < 4; ++box) {
      const double mu = scale * (1 << box), s = softer(mu, 3);
      friction.push_back(mu);
      pyramidal.push_back(p[box].depth);
      elliptic.push_back(e[box].depth);
      formula.push_back(1000 * depth_at_rest(9.81, s, 4));
      if (scale < 1) continue;
      // Four edges side by side are four times as stiff as one.
      std::printf("%8.0f  %8.2f  %8.2f  %10.2f  %6.1f  %7.1f\n", mu,
                  e[box].depth, p[box].depth, formula.back(),
                  p[box].edge / 4 / e[box].edge, s);
      result(std::string("pyramidal_") + names[box], p[box].depth);
      result(std::string("elliptic_") + names[box], e[box].depth);
      result(std::string("softer_") + names[box], s);
    }
  }
  result("doubling", softer(8, 3) / softer(4, 3));
  table("depths", {{"friction", friction},
                   {"pyramidal", pyramidal},
                   {"elliptic", elliptic},
                   {"formula", formula}});
}
