// Lesson 2.2: a contact, tuned in seven steps.
//
// INPUT    ramp.xml as somebody left it, with friction 4 against the slip; what
//          is wanted: under 40 N, at most 0.1 mm deep, at most 0.01 mm/s of
//          creep, and at most 0.2 of its speed kept
// PROCESS  the steps of the lesson, one after the other: each measures one
//          number and, where it is not as wanted, works out one setting
// OUTPUT   what was measured, and what was set
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l2_2_tune

#include <cmath>
#include <cstdio>
#include <mjcourse/mjcourse.hpp>
#include <mjcourse/ramp.hpp>

using namespace mjcourse;

int main() {
  const double depth = 1e-4, creep = 1e-5, bounce = 0.2;  // m, m/s
  const double load = 40;                                 // N
  const double share = 0.9;  // of what is allowed, so that some is left
  const Model model = load_model("ramp");
  const int ramp = id_of(model, mjOBJ_GEOM, "ramp");
  mjtNum* friction = model->geom_friction + 3 * ramp;
  mjtNum* solref = model->geom_solref + mjNREF * ramp;
  mjtNum* solimp = model->geom_solimp + mjNIMP * ramp;
  friction[0] = 4;

  // #region steps
  // 1. Whose numbers count? Those of the contact, not those of a geom.
  const Data data = make_data(model);
  while (data->time < 0.1) mj_step(model, data);
  const mjContact& contact = data->contact[0];
  const int corners = data->ncon, edges = 2 * (contact.dim - 1);
  std::printf("1 contact  %d, each with friction %.0f, solref %.2f %.0f\n",
              corners, contact.friction[0], contact.solref[0],
              contact.solref[1]);

  // 2. The cone: no pyramid where it is softer than asked for.
  const double square = friction[0] * friction[0];
  std::printf("2 cone     %.0f times as soft as an elliptic one",
              2 * square * (1 + square) / edges);
  model->opt.cone = mjCONE_ELLIPTIC;
  friction[0] = 1;  // what the material has
  std::printf(": elliptic, friction 1\n");

  // 3. The bounce: the damping ratio.
  std::printf("3 bounce   keeps %.2f of its speed", kept(model));
  if (kept(model) > bounce) solref[1] = 1;
  std::printf(": damping ratio %.0f, and %.2f\n", solref[1], kept(model));

  // 4. The depth: the time constant, or 1 - d where that would be too short.
  Found found = measure(model, load);
  std::printf("4 depth    %.3f mm", 1000 * found.depth);
  const double mass = model->body_mass[id_of(model, mjOBJ_BODY, "box")];
  const double a = (9.81 + load / mass) * std::cos(15 * M_PI / 180);
  double d = solimp[0] = solimp[1];
  const double allowed = share * depth * corners / a / std::pow(solref[1], 2);
  solref[0] = std::sqrt(allowed / (1 - d));
  if (solref[0] < 2 * model->opt.timestep) {
    solref[0] = 2 * model->opt.timestep;
    d = solimp[0] = solimp[1] = 1 - allowed / std::pow(solref[0], 2);
  }
  found = measure(model, load);
  std::printf(": T = %.4f s, d = %.2f, and %.3f mm\n", solref[0], d,
              1000 * found.depth);

  // 5. The creep: impratio.
  std::printf("5 creep    %.3f mm/s", 1000 * found.creep);
  model->opt.impratio = std::ceil(found.creep / (share * creep));
  found = measure(model, load);
  std::printf(": impratio %.0f, and %.4f mm/s\n", model->opt.impratio,
              1000 * found.creep);

  // 6. Half the step must not change them.
  model->opt.timestep /= 2;
  const Found half = measure(model, load);
  std::printf("6 step     half of it: %.3f mm, %.4f mm/s, keeps %.2f\n",
              1000 * half.depth, 1000 * half.creep, half.kept);
  model->opt.timestep *= 2;

  // 7. The solver must have come to its end.
  std::printf("7 solver   %d iterations of %d\n", found.iterations,
              model->opt.iterations);
  // #endregion
  result("depth", 1000 * found.depth);
  result("creep", 1000 * found.creep);
  result("impratio", model->opt.impratio);
  result("time", solref[0]);
}
