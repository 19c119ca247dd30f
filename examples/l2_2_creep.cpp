// Lesson 2.2, challenge: the better it grips, the faster it slides.
//
// INPUT    ramp.xml, a box on a slope of 15 degrees, its impedance the same at
//          any depth
// PROCESS  for both friction cones, measure how fast the box creeps
// OUTPUT   speeds, measured and worked out; checks other models
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l2_2_creep

#include <cmath>
#include <cstdio>
#include <mjcourse/mjcourse.hpp>
#include <mjcourse/ramp.hpp>

using namespace mjcourse;

struct Contact {
  bool pyramidal;
  double friction, impratio;
  double time, d;  // time constant (s); impedance, the same at any depth
  int corners;     // as many such contacts share the load
};

// How fast (m/s) a body creeps that would slide off with the acceleration a if
// there were no friction.
double creep(const Contact& contact, double a) {
  const auto& [pyramidal, mu, impratio, time, d, n] = contact;
  // #region answer
  const double elliptic = (1 - d) * time * a / (2 * n * impratio);
  return pyramidal ? (1 + mu * mu) * elliptic : elliptic;
  // #starter
  // return (1 - d) * time * a / 2;  // one contact, elliptic, impratio 1
  // #wrong forgets-the-corners: with elliptic cones
  // const double elliptic = (1 - d) * time * a / (2 * impratio);
  // return pyramidal ? (1 + mu * mu) * elliptic : elliptic;
  // #wrong multiplies-impratio: with elliptic cones
  // const double elliptic = (1 - d) * time * a * impratio / (2 * n);
  // return pyramidal ? (1 + mu * mu) * elliptic : elliptic;
  // #wrong divides-by-friction: with elliptic cones
  // return (1 - d) * time * a / (2 * n * impratio * mu);
  // #wrong knows-one-cone: with pyramids
  // return (1 - d) * time * a / (2 * n * impratio);
  // #wrong takes-the-normal: with pyramids
  // const double elliptic = (1 - d) * time * a / (2 * n * impratio);
  // const double square = mu * mu;
  // return pyramidal ? square * (1 + square) / 2 * elliptic : elliptic;
  // #wrong forgets-the-normal: with pyramids
  // const double elliptic = (1 - d) * time * a / (2 * n * impratio);
  // return pyramidal ? 2 * mu * mu * elliptic : elliptic;
  // #endregion
}

double slide(const Model& model, const Contact& contact) {
  const int ramp = id_of(model, mjOBJ_GEOM, "ramp");
  model->opt.cone = contact.pyramidal ? mjCONE_PYRAMIDAL : mjCONE_ELLIPTIC;
  model->opt.impratio = contact.impratio;
  model->geom_friction[3 * ramp] = contact.friction;
  model->geom_solref[mjNREF * ramp] = contact.time;
  model->geom_solimp[mjNIMP * ramp] = contact.d;
  model->geom_solimp[mjNIMP * ramp + 1] = contact.d;
  return measure(model, 0).creep;
}

int main() {
  const Model model = load_model("ramp");
  const double a = 9.81 * std::sin(15 * M_PI / 180);
  std::printf("mm/s      elliptic            pyramidal\n");
  std::printf("friction  measured  formula   measured  formula\n");
  for (const double friction : {0.6, 1.0, 2.0, 4.0}) {
    std::printf("%8.1f", friction);
    for (const bool pyramidal : {false, true}) {
      const Contact contact{pyramidal, friction, 1, 0.02, 0.95, 4};
      const double v = slide(model, contact);
      std::printf("  %8.3f %8.3f ", 1000 * v, 1000 * creep(contact, a));
      if (friction == 4) result(pyramidal ? "pyramidal" : "elliptic", 1000 * v);
    }
    std::printf("\n");
  }

  for (const bool pyramidal : {false, true}) {
    for (const Contact& contact : {Contact{pyramidal, 0.6, 1, 0.02, 0.95, 4},
                                   Contact{pyramidal, 1.5, 1, 0.03, 0.9, 4},
                                   Contact{pyramidal, 3, 5, 0.02, 0.9, 4}}) {
      const double v = slide(model, contact);
      if (!expect_near(
              creep(contact, a), v, 0.01 * v,
              pyramidal ? "with pyramids, the box creeps as fast"
                        : "with elliptic cones, the box creeps as fast",
              pyramidal ? "two edges resist along a tangent, and the R of "
                          "an edge is not that of elliptic friction"
                        : "n contacts share the load, impratio divides R, "
                          "and friction is only a limit"))
        return 0;
    }
  }
}
