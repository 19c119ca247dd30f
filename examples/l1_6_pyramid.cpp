// Lesson 1.6, challenge: with pyramids, a slippery floor is a hard one.
//
// INPUT    soft_floor.xml, its impedance the same at any depth, T = 0.1 s
// PROCESS  for both friction cones and four coefficients of friction, measure
//          the depth of the 1 kg ball, and read R of its first constraint
// OUTPUT   depths; how much harder pyramids are, and what R predicts
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l1_6_pyramid

#include <cmath>
#include <cstdio>
#include <mjcourse/mjcourse.hpp>

using namespace mjcourse;

struct Resting {
  double depth, regularizer;  // m; R, in 1/kg
};

Resting rest(const Model& model, int cone, double friction) {
  model->opt.cone = cone;
  model->geom_friction[3 * id_of(model, mjOBJ_GEOM, "floor")] = friction;
  const Data data = make_data(model);
  for (int step = 0; step < 1500; ++step) mj_step(model, data);
  mj_forward(model, data);
  const mjContact& contact = data->contact[1];  // the ball of 1 kg
  return {-contact.dist, data->efc_R[contact.efc_address]};
}

int main() {
  const Model model = load_model("soft_floor");
  const int floor = id_of(model, mjOBJ_GEOM, "floor");
  model->geom_solref[mjNREF * floor] = 0.1;
  model->geom_solimp[mjNIMP * floor] = model->geom_solimp[mjNIMP * floor + 1];

  std::printf("                                          times harder\n");
  std::printf("mu   elliptic (mm)  pyramidal (mm)  measured  by R  formula\n");
  for (const double friction : {1.0, 0.7, 0.5, 0.3}) {
    const Resting e = rest(model, mjCONE_ELLIPTIC, friction);
    const Resting p = rest(model, mjCONE_PYRAMIDAL, friction);
    const double square = friction * friction;
    std::printf("%.1f  %13.3f  %14.3f  %8.2f  %5.2f  %7.2f\n", friction,
                1000 * e.depth, 1000 * p.depth, e.depth / p.depth,
                4 * e.regularizer / p.regularizer, 2 / (square * (1 + square)));
    if (friction == 0.5) result("harder_at_half", e.depth / p.depth);
  }
}
