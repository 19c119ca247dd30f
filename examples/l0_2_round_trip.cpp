// Lesson 0.2, challenge: out of the model into a file, and back.
//
// INPUT    scales.xml
// PROCESS  save it with mj_saveLastXML and compile that; save it with
//          mj_saveModel and load that; do both again after the box was doubled in
//          the mjModel
// OUTPUT   the mass of the left side, and how far the range of the tilt is off
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l0_2_round_trip

#include <cmath>
#include <cstdio>
#include <mjcourse/mjcourse.hpp>

using namespace mjcourse;

Model through_xml(const Model& model) {
  char error[1000] = "";
  if (mj_saveLastXML("saved.xml", model, error, sizeof error) == 0)
    throw std::runtime_error(error);
  return load_model_file("saved.xml");
}

Model through_mjb(const Model& model) {
  mj_saveModel(model, "saved.mjb", nullptr, 0);
  mjModel* loaded = mj_loadModel("saved.mjb", nullptr);
  if (loaded == nullptr) throw std::runtime_error("saved.mjb was not loaded");
  return Model(loaded);
}

void show(const char* name, const Model& original, const Model& copy) {
  const int left = id_of(original, mjOBJ_BODY, "left");
  const double off = std::abs(copy->jnt_range[1] - original->jnt_range[1]);
  std::printf("%-24s %6.2f kg  %s\n", name, copy->body_mass[left],
              off == 0     ? "same bits"
              : off < 1e-6 ? "below 1e-6"
                           : "far");
}

int main() {
  const Model model = load_model("scales");
  std::puts("                           left  range of the tilt");
  show("as compiled", model, model);
  show("through XML", model, through_xml(model));
  const Model again = load_model("scales");  // the last one that XML knows of
  show("through MJB", again, through_mjb(again));

  const int box = id_of(again, mjOBJ_GEOM, "box");
  for (const int side : {0, 1, 2}) again->geom_size[3 * box + side] *= 2;
  show("box doubled in mjModel", again, again);
  show("... and through MJB", again, through_mjb(again));
  show("... and through XML", again, through_xml(again));
}
