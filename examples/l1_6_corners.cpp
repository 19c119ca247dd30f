// Lesson 1.6, exercise: a floor into which the crate sinks by 2 mm.
//
// INPUT    push_crate.xml: 1 kg on four corners, with elliptic friction cones
// PROCESS  work out the time constant; simulate; measure the depth
// OUTPUT   the time constant and the depth
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l1_6_corners

#include <cmath>
#include <cstdio>
#include <mjcourse/mjcourse.hpp>

using namespace mjcourse;

int main() {
  const Model model = load_model("push_crate");
  model->opt.cone = mjCONE_ELLIPTIC;
  const int floor = id_of(model, mjOBJ_GEOM, "floor");
  const double wanted = 0.002, d = model->geom_solimp[mjNIMP * floor + 1];
  const int corners = 4;  // each carries a quarter

  // p = (1 - d) g T^2 / corners, and d is dmax at this depth
  const double time = std::sqrt(corners * wanted / ((1 - d) * 9.81));
  model->geom_solref[mjNREF * floor] = time;

  const Data data = make_data(model);
  for (int step = 0; step < 1500; ++step) mj_step(model, data);
  mj_forward(model, data);
  const double depth = -data->contact[0].dist;
  std::printf("time constant %.4f s: %d contacts, depth %.4f mm\n", time,
              data->ncon, 1000 * depth);
  result("time", time);
  result("depth", 1000 * depth);
  result("alone", 1000 * corners * wanted);  // mm, on one contact
}
