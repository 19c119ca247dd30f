// Lesson 0.2, exercise: a ball that weighs as much as the box.
//
// INPUT    unequal_scales.xml, and the sizes of its box
// PROCESS  compute the radius of a ball of the same volume; write it into the
//          model's text, rounded to a tenth of a millimetre; compile; let it settle
// OUTPUT   the radius, both masses, the tilt after five seconds
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l0_2_counterweight

#include <cmath>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <mjcourse/mjcourse.hpp>
#include <string>

using namespace mjcourse;

int main() {
  const double volume = 8 * 0.05 * 0.04 * 0.03;  // m^3, of the box
  const double radius = std::cbrt(3 * volume / (4 * M_PI));
  char ball[100];
  std::snprintf(ball, sizeof ball,
                "<geom type=\"sphere\" pos=\"0 0 -0.17\" size=\"%.4f\"/>",
                radius);

  std::ifstream file(models_directory() / "unequal_scales.xml");
  std::string mjcf{std::istreambuf_iterator<char>(file), {}};
  mjcf.insert(mjcf.find("<!-- hang a ball here -->"), ball);
  const Model model = load_model_xml(mjcf);
  std::printf("%s\n", ball);
  const auto mass = [&](const char* side) {
    return model->body_mass[id_of(model, mjOBJ_BODY, side)];
  };
  for (const char* side : {"left", "right"})
    std::printf("%-5s %.4f kg\n", side, mass(side));

  const Data data = make_data(model);
  while (data->time < 5) mj_step(model, data);
  std::printf("tilt  %.2f degrees\n", data->qpos[0] * 180 / M_PI);
  result("radius_mm", 1000 * radius);
  result("grams_off", 1000 * (mass("right") - mass("left")));
}
