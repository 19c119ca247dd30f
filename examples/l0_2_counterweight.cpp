// Lesson 0.2, exercise: a ball that weighs as much as the box.
//
// INPUT    unequal_scales.xml, and the sizes of its box
// PROCESS  compute the radius of a ball of the same volume; write it into the
//          model's text, rounded to a tenth of a millimetre; compile; let it
//          settle
// OUTPUT   the radius, both masses, the tilt after five seconds; checks the
//          masses, also with other boxes
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

// The number that the text of a ball has as its `size`, so that it weighs as
// much as a box of the same density. `box` has the three numbers that the text
// of the box has as its `size`. In metres.
double ball_size(const Eigen::Vector3d& box) {
  // #region answer
  const double volume = 8 * box.prod();
  return std::cbrt(3 * volume / (4 * M_PI));
  // #starter
  // return 0;  // which volume does the box have?
  // #wrong whole-edges: the ball is heavy enough
  // return std::cbrt(3 * box.prod() / (4 * M_PI));
  // #wrong diameter: the ball is light enough
  // return 2 * std::cbrt(3 * 8 * box.prod() / (4 * M_PI));
  // #wrong area: the ball is light enough
  // const double a = box[0], b = box[1], c = box[2];
  // return std::sqrt(8 * (a * b + b * c + c * a) / (4 * M_PI));
  // #wrong this-box-only: the same rule balances other boxes
  // return 0.0486;
  // #endregion
}

std::string ball_text(double size) {
  char text[100];
  std::snprintf(text, sizeof text,
                "<geom type=\"sphere\" pos=\"0 0 -0.17\" size=\"%.4f\"/>",
                size);
  return text;
}

// The scales with a box of this `size` on the left, and a ball on the right.
Model load_scales(const Eigen::Vector3d& box, double ball) {
  std::ifstream file(models_directory() / "unequal_scales.xml");
  std::string mjcf{std::istreambuf_iterator<char>(file), {}};
  mjcf.insert(mjcf.find("<!-- hang a ball here -->"), ball_text(ball));
  char size[100];
  std::snprintf(size, sizeof size, "%g %g %g", box[0], box[1], box[2]);
  const std::string old = "0.05 0.04 0.03";
  return load_model_xml(mjcf.replace(mjcf.find(old), old.size(), size));
}

double mass(const Model& model, const char* side) {
  return model->body_mass[id_of(model, mjOBJ_BODY, side)];
}

int main() {
  const Eigen::Vector3d box(0.05, 0.04, 0.03);
  const double ball = ball_size(box);
  std::printf("%s\n", ball_text(ball).c_str());
  if (!expect(ball > 0.001 && ball < 1, "the ball has a size in metres",
              "a weight of these scales is some centimetres large"))
    return 0;

  const Model model = load_scales(box, ball);
  const double left = mass(model, "left"), right = mass(model, "right");
  std::printf("left  %.4f kg\nright %.4f kg\n", left, right);
  const Data data = make_data(model);
  while (data->time < 5) mj_step(model, data);
  std::printf("tilt  %.2f degrees\n", data->qpos[0] * 180 / M_PI);
  result("radius_mm", 1000 * ball);
  result("grams_off", 1000 * (right - left));

  const bool is_heavy = expect(right > 0.99 * left, "the ball is heavy enough",
                               "the box is larger than it was taken for");
  const bool is_light = expect(right < 1.01 * left, "the ball is light enough",
                               "its volume is not the volume of the box");
  if (!is_heavy || !is_light) return 0;
  for (const Eigen::Vector3d& other :
       {Eigen::Vector3d(0.02, 0.03, 0.1), Eigen::Vector3d(0.06, 0.06, 0.06)}) {
    const double size = std::fmin(std::fmax(ball_size(other), 0.001), 1);
    const Model scales = load_scales(other, size);
    expect_near(mass(scales, "right"), mass(scales, "left"), 0.004,
                "the same rule balances other boxes",
                "the radius does not follow from the three sizes");
  }
}
