// Lesson 1.6, challenge: with pyramids, a slippery floor is a hard one.
//
// INPUT    soft_floor.xml, its impedance the same at any depth, T = 0.1 s
// PROCESS  for both friction cones and four coefficients of friction, measure
//          the depth of the 1 kg ball, and read R of its first constraint
// OUTPUT   depths; how much harder pyramids are, and what R predicts; checks
//          the prediction for other balls, and with torsional friction
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l1_6_pyramid

#include <cmath>
#include <cstdio>
#include <mjcourse/mjcourse.hpp>

using namespace mjcourse;

// How stiff a contact is along its normal, in kg: the sum of 1/R over the
// constraints that carry the normal force. R is data->efc_R, one number for
// each constraint; the model's cone is model->opt.cone.
double stiffness(const Model& model, const Data& data,
                 const mjContact& contact) {
  // #region answer
  if (model->opt.cone == mjCONE_ELLIPTIC)  // the normal, then the tangents
    return 1 / data->efc_R[contact.efc_address];
  double sum = 0;
  for (int edge = 0; edge < 2 * (contact.dim - 1); ++edge)
    sum += 1 / data->efc_R[contact.efc_address + edge];
  return sum;
  // #starter
  // return 1 / data->efc_R[0];  // of the first constraint of all
  // #wrong knows-no-address: ten times the load
  // if (model->opt.cone == mjCONE_ELLIPTIC) return 1 / data->efc_R[1];
  // return 4 / data->efc_R[1];
  // #wrong takes-one-edge: the pyramid's depth agrees
  // return 1 / data->efc_R[contact.efc_address];
  // #wrong takes-three-edges: the pyramid's depth agrees
  // double sum = 1 / data->efc_R[contact.efc_address];
  // const int rows = model->opt.cone == mjCONE_PYRAMIDAL ? contact.dim : 1;
  // for (int i = 1; i < rows; ++i)
  //   sum += 1 / data->efc_R[contact.efc_address + i];
  // return sum;
  // #wrong takes-four-edges-always: torsional friction adds
  // const double one = 1 / data->efc_R[contact.efc_address];
  // return model->opt.cone == mjCONE_ELLIPTIC ? one : 4 * one;
  // #endregion
}

struct Resting {
  double depth, stiffness;  // m, kg
};

Resting rest(const Model& model, int cone, double friction, int ball = 1) {
  model->opt.cone = cone;
  model->geom_friction[3 * id_of(model, mjOBJ_GEOM, "floor")] = friction;
  const Data data = make_data(model);
  for (int step = 0; step < 1500; ++step) mj_step(model, data);
  mj_forward(model, data);
  const mjContact& contact =
      data->contact[ball];  // of one ball after the other
  return {-contact.dist, stiffness(model, data, contact)};
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
                p.stiffness / e.stiffness, 2 / (square * (1 + square)));
    if (friction == 0.5) result("harder_at_half", e.depth / p.depth);
  }

  for (const double friction : {0.4, 0.8}) {
    const Resting middle = rest(model, mjCONE_ELLIPTIC, friction);
    const Resting heavy = rest(model, mjCONE_ELLIPTIC, friction, 2);
    if (!expect_near(heavy.stiffness * heavy.depth,
                     10 * middle.stiffness * middle.depth,
                     0.01 * std::abs(heavy.stiffness * heavy.depth),
                     "ten times the load needs ten times the force",
                     "the constraints of a contact begin at its efc_address"))
      return 0;
    for (const int dim : {3, 4}) {
      model->geom_condim[floor] = dim;
      const Resting e = rest(model, mjCONE_ELLIPTIC, friction);
      const Resting p = rest(model, mjCONE_PYRAMIDAL, friction);
      const double harder = e.depth / p.depth;
      if (!expect_near(p.stiffness / e.stiffness, harder, 0.01 * harder,
                       dim == 3
                           ? "the pyramid's depth agrees with its stiffness"
                           : "torsional friction adds two edges",
                       "every edge of a pyramid carries a part of the normal "
                       "force, and an "
                       "elliptic cone has no edges"))
        return 0;
    }
    model->geom_condim[floor] = 3;
  }
}
