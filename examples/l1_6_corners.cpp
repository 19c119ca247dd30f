// Lesson 1.6, exercise: a floor into which the crate sinks by 2 mm.
//
// INPUT    push_crate.xml: 1 kg on four corners, with elliptic friction cones;
//          soft_floor.xml: balls of 0.1, 1 and 10 kg, each on one contact
// PROCESS  work out the time constant; simulate; measure the depth
// OUTPUT   the time constant and the depth; checks the depth of all bodies, and
//          with another dmax
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l1_6_corners

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <mjcourse/mjcourse.hpp>

using namespace mjcourse;

// The time constant (s) of a floor into which a body sinks by `depth` (m) when
// it rests on that many corners. d is the impedance at this depth, between 0
// and 1; g is positive.
double time_constant(double depth, int corners, double d, double g) {
  // #region answer
  // One contact would give way by (1 - d) g T^2; each carries a share.
  return std::sqrt(corners * depth / ((1 - d) * g));
  // #starter
  // return 0;  // solve the depth of a body at rest for T
  // #wrong forgets-the-corners: on four corners
  // return std::sqrt(depth / ((1 - d) * g));
  // #wrong divides-by-corners: on four corners
  // return std::sqrt(depth / (corners * (1 - d) * g));
  // #wrong swaps-d: on one contact
  // return std::sqrt(corners * depth / (d * g));
  // #wrong knows-one-gravity: with another dmax
  // return std::sqrt(corners * depth / ((1 - d) * 9.81));
  // #wrong knows-one-d: with another dmax
  // return std::sqrt(corners * depth / ((1 - 0.95) * g));
  // #endregion
}

struct Resting {
  int contacts = 0;
  double depth = 0;  // m, of the deepest contact
};

// After three seconds on a floor with this time constant. Without one that can
// be, nothing is measured.
Resting rest(const Model& model, double time) {
  if (!(time > 0)) return {};
  model->geom_solref[mjNREF * id_of(model, mjOBJ_GEOM, "floor")] = time;
  const Data data = make_data(model);
  for (int step = 0; step < 1500; ++step) mj_step(model, data);
  mj_forward(model, data);
  Resting found{data->ncon};
  for (int i = 0; i < data->ncon; ++i)
    found.depth = std::max(found.depth, -data->contact[i].dist);
  return found;
}

int main() {
  const Model crate = load_model("push_crate");
  crate->opt.cone = mjCONE_ELLIPTIC;
  const int floor = id_of(crate, mjOBJ_GEOM, "floor"), corners = 4;
  const double wanted = 0.002, d = crate->geom_solimp[mjNIMP * floor + 1];
  const double g = -crate->opt.gravity[2];
  const double time = time_constant(wanted, corners, d, g);
  const Resting found = rest(crate, time);
  std::printf("time constant %.4f s: %d contacts, depth %.4f mm\n", time,
              found.contacts, 1000 * found.depth);
  result("time", time);
  result("depth", 1000 * found.depth);
  result("alone", 1000 * corners * wanted);  // mm, on one contact

  const Model balls = load_model("soft_floor");
  const auto alone = [&](double deep, double dmax, double down) {
    balls->opt.gravity[2] = -down;
    balls->geom_solimp[mjNIMP * id_of(balls, mjOBJ_GEOM, "floor") + 1] = dmax;
    return rest(balls, time_constant(deep, 1, dmax, down)).depth;
  };
  if (!expect_near(alone(0.002, d, g), 0.002, 1e-5,
                   "on one contact, the depth is as wanted",
                   "a contact at rest is (1 - d) g T^2 deep, and T is asked"))
    return 0;
  expect_near(alone(0.003, 0.8, 5), 0.003, 1e-5,
              "with another dmax and g, the depth is as wanted",
              "d and g are parameters");
  expect_near(found.depth, wanted, 1e-5,
              "on four corners, the depth is as wanted",
              "each contact has a spring of its own, made for the whole body");
}
