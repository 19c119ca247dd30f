// Lesson 0.2, challenge: out of the model into a file, and back.
//
// INPUT    scales.xml
// PROCESS  save it with mj_saveLastXML and compile that; save it with
//          mj_saveModel and load that; do both again after the box was doubled
//          in the mjModel
// OUTPUT   the mass of the left side, and how far the range of the tilt is off;
//          checks what each way keeps of the doubled box
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l0_2_round_trip

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <mjcourse/mjcourse.hpp>

using namespace mjcourse;

// Both save `model` to a file and give what that file makes: through_xml saves
// MJCF with the numbers that `model` has now, and compiles it; through_mjb
// saves and loads the numbers themselves.
// #region answer
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
// #starter
// // Save to "saved.xml", compile that.
// Model through_xml(const Model&) { return Model(nullptr); }
//
// // Save to "saved.mjb", load that.
// Model through_mjb(const Model&) { return Model(nullptr); }
// #wrong xml-of-the-text: XML has the sizes that the model has now
// Model through_xml(const Model&) {
//   mj_saveLastXML("saved.xml", nullptr, nullptr, 0);
//   return load_model_file("saved.xml");
// }
//
// Model through_mjb(const Model& model) {
//   mj_saveModel(model, "saved.mjb", nullptr, 0);
//   return Model(mj_loadModel("saved.mjb", nullptr));
// }
// #wrong copy-in-memory: the compiler weighs the doubled box
// Model through_xml(const Model& model) {
//   return Model(mj_copyModel(nullptr, model));
// }
//
// Model through_mjb(const Model& model) {
//   mj_saveModel(model, "saved.mjb", nullptr, 0);
//   return Model(mj_loadModel("saved.mjb", nullptr));
// }
// #wrong both-by-xml: MJB keeps every bit
// Model through_xml(const Model& model) {
//   char error[1000] = "";
//   mj_saveLastXML("saved.xml", model, error, sizeof error);
//   return load_model_file("saved.xml");
// }
//
// Model through_mjb(const Model& model) { return through_xml(model); }
// #endregion

double left_mass(const Model& model) {
  return model->body_mass[id_of(model, mjOBJ_BODY, "left")];
}

void show(const char* name, const Model& original, const Model& copy) {
  const double off = std::abs(copy->jnt_range[1] - original->jnt_range[1]);
  std::printf("%-24s %6.2f kg  %s\n", name, left_mass(copy),
              off == 0     ? "same bits"
              : off < 1e-6 ? "below 1e-6"
                           : "far");
}

// Shows what came back of a model, and gives it; null where it is no model of
// the same bodies.
Model came(const char* name, const Model& original, Model copy) {
  const bool is_there =
      expect(copy != nullptr && copy->nbody == original->nbody &&
                 copy->ngeom == original->ngeom && copy->njnt == original->njnt,
             "each way gives back a model of the same bodies",
             "nothing came back, or another model");
  if (!is_there) return Model(nullptr);
  show(name, original, copy);
  return copy;
}

int main() {
  const Model model = load_model("scales");
  std::puts("                           left  range of the tilt");
  show("as compiled", model, model);
  came("through XML", model, through_xml(model));
  const Model again = load_model("scales");  // the last one that XML knows of
  came("through MJB", again, through_mjb(again));

  const int box = id_of(again, mjOBJ_GEOM, "box");
  for (const int side : {0, 1, 2}) again->geom_size[3 * box + side] *= 2;
  show("box doubled in mjModel", again, again);
  const Model mjb = came("... and through MJB", again, through_mjb(again));
  const Model xml = came("... and through XML", again, through_xml(again));
  if (mjb == nullptr || xml == nullptr) return 0;

  const auto same = [&](const mjtNum* a, const mjtNum* b, int n) {
    return std::equal(a, a + n, b);
  };
  const double size = again->geom_size[3 * box];
  if (expect(std::abs(xml->geom_size[3 * box] - size) < 1e-6,
             "XML has the sizes that the model has now",
             "the file has the sizes of the text that was compiled"))
    expect_near(left_mass(xml), 8 * 0.48 + 0.12, 1e-3,
                "the compiler weighs the doubled box anew",
                "the mass comes out of the old model, not out of the text");
  expect(same(mjb->geom_size, again->geom_size, 3 * again->ngeom) &&
             same(mjb->jnt_range, again->jnt_range, 2 * again->njnt) &&
             same(mjb->body_mass, again->body_mass, again->nbody),
         "MJB keeps every bit of sizes, ranges and masses",
         "these numbers were computed or rounded on the way");
}
