// A model of two files, and a header of the course's own beside the tool's.
#include <cstdio>

#include "mjcourse/mjcourse.hpp"
#include "own/greeting.hpp"

int main() {
  const auto model = mjcourse::load_model("pair");
  std::printf("%d bodies, from %s\n", model->nbody - 1, greeting());
  // #region mass
  double mass = 0;
  for (int i = 0; i < model->nbody; ++i) mass += model->body_mass[i];
  std::printf("mass: %.2f kg\n", mass);
  // #endregion
}
