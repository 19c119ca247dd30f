// Lesson 2.2: which number of a model changes which number that you see.
//
// INPUT    ramp.xml, softer and bouncier than by default, so that everything
//          can be measured
// PROCESS  with both friction cones: measure the box's depth, bounce and creep;
//          double one number of the model; measure again
// OUTPUT   the factors by which the three have changed
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l2_2_knobs

#include <cstdio>
#include <mjcourse/mjcourse.hpp>
#include <mjcourse/ramp.hpp>

using namespace mjcourse;

// #region change
// Doubles one number of the model.
void change(const Model& model, int ramp, const std::string& which) {
  mjtNum* solref = model->geom_solref + mjNREF * ramp;
  mjtNum* solimp = model->geom_solimp + mjNIMP * ramp;
  if (which == "friction") model->geom_friction[3 * ramp] *= 2;
  if (which == "damping ratio") solref[1] *= 2;
  if (which == "time constant") solref[0] *= 2;
  if (which == "1 - d") solimp[0] = solimp[1] = 1 - 2 * (1 - solimp[1]);
  if (which == "impratio") model->opt.impratio *= 2;
}
// #endregion

int main() {
  for (const int cone : {mjCONE_ELLIPTIC, mjCONE_PYRAMIDAL}) {
    std::printf("%-15s   bounce    depth    creep\n",
                cone == mjCONE_ELLIPTIC ? "elliptic" : "pyramidal");
    Found before{};
    for (const char* which : {"nothing", "damping ratio", "time constant",
                              "1 - d", "impratio", "friction"}) {
      const Model model = load_model("ramp");
      const int ramp = id_of(model, mjOBJ_GEOM, "ramp");
      model->opt.cone = cone;
      model->opt.timestep = 0.0005;
      model->geom_solref[mjNREF * ramp] = 0.1;      // s
      model->geom_solref[mjNREF * ramp + 1] = 0.3;  // damping ratio
      model->geom_solimp[mjNIMP * ramp] = 0.95;     // d, at any depth
      change(model, ramp, which);
      const Found found = measure(model, 0);
      if (before.depth == 0) before = found;
      std::printf("%-15s %8.2f %8.2f %8.2f\n", which, found.kept / before.kept,
                  found.depth / before.depth, found.creep / before.creep);
    }
  }
}
