// @name@: an exercise: how much a model weighs.
//
// INPUT    @model@.xml
// PROCESS  add up the masses of its bodies
// OUTPUT   the sum; checks it against MuJoCo's own
//
// A lesson asks for it by an empty fence `cpp exercise file=examples/@name@.cpp#answer`.

#include <mjcourse/mjcourse.hpp>

using namespace mjcourse;

// The mass of all bodies of the model, in kg.
double total_mass(const Model& model) {
  // #region answer
  double mass = 0;
  for (int body = 0; body < model->nbody; ++body) mass += model->body_mass[body];
  return mass;
  // #starter
  // return 0;  // which array of mjModel has a number for each body?
  // #wrong counts-bodies: the sum is MuJoCo's
  // return model->nbody;
  // #wrong leaves-out-the-last: the sum is MuJoCo's
  // double mass = 0;
  // for (int body = 0; body < model->nbody - 1; ++body) mass += model->body_mass[body];
  // return mass;
  // #endregion
}

int main() {
  const Model model = load_model("@model@");
  print("mass (kg):", total_mass(model));
  expect_near(total_mass(model), model->body_subtreemass[0], 1e-9, "the sum is MuJoCo's",
              "it is another number, or a body is left out");
}
