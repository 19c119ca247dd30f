// Lesson 0.3, exercise: how high is the crate? From the depth alone.
//
// INPUT    still_life.xml, seen by its camera "eye"
// PROCESS  go up one column of pixels through the crate's front; count those
//          that are as far away as its front
// OUTPUT   their number, and the height that they make
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l0_3_crate

#include <GL/osmesa.h>

#include <cmath>
#include <cstdio>
#include <mjcourse/offscreen.hpp>

using namespace mjcourse;

int main() {
  const ScreenlessContext opengl;
  const Model model = load_model("still_life");
  model->vis.quality.offsamples = 0;
  const Data data = make_data(model);
  mj_forward(model, data);
  const int width = 640, height = 480, column = 180;
  Renderer renderer(model, width, height);
  const Picture picture = renderer.render(data, fixed_camera(model, "eye"));

  const double near = model->vis.map.znear * model->stat.extent;
  const double far = model->vis.map.zfar * model->stat.extent;
  const auto depth = [&](int row) {  // m
    const double buffer = picture.depth[column + width * row];
    return near * far / (far - buffer * (far - near));
  };
  const double front = depth(170);  // a row that shows the crate's front
  int count = 0;
  for (int row = 0; row < height; ++row)
    count += std::abs(depth(row) - front) < 0.001;

  const double half = model->cam_fovy[0] / 2 * M_PI / 180;
  const double f = height / 2 / std::tan(half);  // in pixels
  std::printf("%d pixels, %.1f mm each: %.3f m\n", count, 1000 * front / f,
              count * front / f);
  result("front", front);
  result("pixels", count);
  result("pixel_mm", 1000 * front / f);
  result("height", count * front / f);
}
