// Lesson 0.3, exercise: how high is the crate? From the depth alone.
//
// INPUT    still_life.xml, seen by its camera "eye"
// PROCESS  go up one column of pixels through the crate's front; count those
//          that are as far away as its front
// OUTPUT   their number, and the height that they make; checks both, also with
//          another angle of the camera and a smaller picture
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l0_3_crate

#include <GL/osmesa.h>

#include <cmath>
#include <cstdio>
#include <mjcourse/offscreen.hpp>

using namespace mjcourse;
using Eigen::VectorXd;

struct Front {
  int pixels;    // of the column that show the front
  double pixel;  // how high the front is behind each of them, in m
};

// `depth` has the depths of a whole column of the picture, in m, the lowest row
// first. In the row `row` it shows the front of a crate, which is upright and
// faces the camera. `fovy` is the camera's vertical angle of view, in degrees.
Front measure(const VectorXd& depth, int row, double fovy) {
  // #region answer
  const double front = depth[row];
  const auto is_front = (depth.array() - front).abs() < 0.001;
  const double half = fovy / 2 * M_PI / 180;
  const double f = depth.size() / 2.0 / std::tan(half);  // in pixels
  return {static_cast<int>(is_front.count()), front / f};
  // #starter
  // // Count the pixels that are as far away as the one in `row`.
  // return {0, 0};
  // #wrong nearest-pixel: it counts the pixels of the front
  // const double front = depth.minCoeff();
  // const auto is_front = (depth.array() - front).abs() < 0.001;
  // const double f = depth.size() / 2.0 / std::tan(fovy * M_PI / 360);
  // return {static_cast<int>(is_front.count()), front / f};
  // #wrong coarse: it counts the pixels of the front
  // const auto is_front = (depth.array() - depth[row]).abs() < 0.02;
  // const double f = depth.size() / 2.0 / std::tan(fovy * M_PI / 360);
  // return {static_cast<int>(is_front.count()), depth[row] / f};
  // #wrong degrees: the height is right to a pixel
  // const auto is_front = (depth.array() - depth[row]).abs() < 0.001;
  // const double f = depth.size() / 2.0 / std::tan(fovy / 2);
  // return {static_cast<int>(is_front.count()), depth[row] / f};
  // #wrong whole-angle: the height is right to a pixel
  // const auto is_front = (depth.array() - depth[row]).abs() < 0.001;
  // const double f = depth.size() / 2.0 / std::tan(fovy * M_PI / 180);
  // return {static_cast<int>(is_front.count()), depth[row] / f};
  // #wrong this-picture-only: another camera measures the same
  // const auto is_front = (depth.array() - depth[row]).abs() < 0.001;
  // const double f = 240 / std::tan(fovy * M_PI / 360);
  // return {static_cast<int>(is_front.count()), depth[row] / f};
  // #endregion
}

struct View {
  int width, height, column, row;
};

VectorXd depths(const mjModel* model, const View& view, Renderer& renderer) {
  const Data data = make_data(model);
  mj_forward(model, data);
  const Picture picture = renderer.render(data, fixed_camera(model, "eye"));
  const double near = model->vis.map.znear * model->stat.extent;
  const double far = model->vis.map.zfar * model->stat.extent;
  VectorXd depth(view.height);
  for (int row = 0; row < view.height; ++row) {
    const double buffer = picture.depth[view.column + view.width * row];
    depth[row] = near * far / (far - buffer * (far - near));
  }
  return depth;
}

// How many pixels the crate's front should have: MuJoCo says how high the part
// of the world is that the picture shows there.
double pixels_by_mujoco(const View& view, const Renderer& renderer,
                        double front, double height) {
  const mjvGLCamera& eye = renderer.scene.camera[0];
  const double seen =
      front * (eye.frustum_top - eye.frustum_bottom) / eye.frustum_near;
  return view.height * height / seen;
}

int main() {
  const ScreenlessContext opengl;
  const Model model = load_model("still_life");
  model->vis.quality.offsamples = 0;
  const double height =
      2 * model->geom_size[3 * id_of(model, mjOBJ_GEOM, "crate") + 2];

  const View view{640, 480, 180, 170};
  Renderer renderer(model, view.width, view.height);
  const VectorXd depth = depths(model, view, renderer);
  const double front = depth[view.row];
  const auto [pixels, pixel] = measure(depth, view.row, model->cam_fovy[0]);
  std::printf("%d pixels, %.1f mm each: %.3f m\n", pixels, 1000 * pixel,
              pixels * pixel);
  result("front", front);
  result("pixels", pixels);
  result("pixel_mm", 1000 * pixel);
  result("height", pixels * pixel);

  if (!expect_near(pixels, pixels_by_mujoco(view, renderer, front, height), 1,
                   "it counts the pixels of the front",
                   "some are missing, or something else is counted, too") ||
      !expect_near(
          pixels * pixel, height, 0.003, "the height is right to a pixel",
          "the pixels are right, but each is taken for too high or too "
          "low"))
    return 0;
  model->cam_fovy[0] = 60;
  const View small{320, 240, 111, 95};
  Renderer other(model, small.width, small.height);
  const Front found = measure(depths(model, small, other), small.row, 60);
  expect_near(found.pixels * found.pixel, height, 0.0085,
              "another camera measures the same",
              "a number of the first picture is still in use");
}
