// Lesson 0.3: how far away each pixel is.
//
// INPUT    still_life.xml, seen by its camera "eye"
// PROCESS  turn the depth buffer into metres
// OUTPUT   the depths of three surfaces, by hand and out of the buffer; for the
//          lesson, every fifth pixel's as the table "pixels", and what the buffer
//          holds at which depth as the table "buffer"
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l0_3_depth

#include <GL/osmesa.h>

#include <cmath>
#include <cstdio>
#include <mjcourse/offscreen.hpp>
#include <string>
#include <vector>

using namespace mjcourse;

constexpr int kWidth = 320, kHeight = 240;

// #region metres
double metres(const mjModel* model, double buffer) {
  const double near = model->vis.map.znear * model->stat.extent;
  const double far = model->vis.map.zfar * model->stat.extent;
  return near * far / (far - buffer * (far - near));
}
// #endregion

void tables(const mjModel* model, const Picture& picture) {
  std::vector<double> column, row, depth, at, buffer;
  for (int v = 2; v < kHeight; v += 5) {
    for (int u = 2; u < kWidth; u += 5) {
      const double z = metres(model, picture.depth[u + kWidth * v]);
      if (z > 20) continue;  // the sky, a backdrop
      column.push_back(u);
      row.push_back(v);
      depth.push_back(z);
    }
  }
  table("pixels", {{"column", column}, {"row", row}, {"metres", depth}});
  for (double b = 0; b < 0.998; b += b < 0.95 ? 0.01 : 0.001) {
    buffer.push_back(b);
    at.push_back(metres(model, b));
  }
  table("buffer", {{"metres", at}, {"buffer", buffer}});
}

int main() {
  const ScreenlessContext opengl;
  const Model model = load_model("still_life");
  model->vis.quality.offsamples = 0;  // one sample a pixel, at its middle
  const Data data = make_data(model);
  mj_forward(model, data);
  Renderer renderer(model, kWidth, kHeight);
  const Picture picture = renderer.render(data, fixed_camera(model, "eye"));

  const auto compare = [&](const char* what, int column, int row, double z) {
    const float buffer = picture.depth[column + kWidth * row];
    const double found = metres(model, buffer);
    std::printf("%-18s  %.4f m    %.6f  %.4f m\n", what, z, buffer, found);
    result(what + std::string("_um"), 1e6 * std::abs(found - z));
  };
  const double crate = 1.6 + 0.25 - 0.15;  // m, where its front is
  const double f = kHeight / 2 / std::tan(model->cam_fovy[0] / 2 * M_PI / 180);
  std::printf("surface             by hand     buffer    as metres\n");
  compare("ball", 160, 120, 1.6 - 0.08);
  compare("crate", 92, 86, crate);
  compare("floor", 160, 20, f * 0.35 / (kHeight / 2 - 20.5));

  const double near = metres(model, 0);
  result("step_um", 1e6 * crate * crate / near / (1 << 24));  // for db = 2^-24
  result("half", metres(model, 0.5));
  tables(model, picture);
}
