// Lesson 0.3: where a point is in the picture, and what each pixel shows.
//
// INPUT    still_life.xml, seen by its camera "eye"
// PROCESS  work out at which pixel the ball's centre is; find the ball's pixels
//          in a picture whose colours are the numbers of its shapes
// OUTPUT   both, for four places of the ball; for the lesson, what every fifth
//          pixel shows, as the table "shown"
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l0_3_pixels

#include <GL/osmesa.h>

#include <cmath>
#include <cstdio>
#include <mjcourse/offscreen.hpp>
#include <vector>

using namespace mjcourse;
using Eigen::Vector2d, Eigen::Vector3d;
using RowMatrix3d = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

constexpr int kWidth = 320, kHeight = 240;

// #region project
// The pixel of a point, counted from the lower left corner.
Vector2d project(const mjModel* model, const mjData* data, int camera,
                 const Vector3d& point) {
  const Vector3d eye(data->cam_xpos + 3 * camera);
  const Eigen::Map<const RowMatrix3d> axes(data->cam_xmat + 9 * camera);
  const Vector3d seen = axes.transpose() * (point - eye);
  const double depth = -seen.z();  // cameras look along their own -z
  const double half = model->cam_fovy[camera] / 2 * M_PI / 180;
  const double f = kHeight / 2 / std::tan(half);  // in pixels
  return Vector2d(kWidth, kHeight) / 2 + f / depth * seen.head<2>();
}
// #endregion

// #region ids
// The geom that is seen at a pixel, or -1.
int geom_at(const Picture& picture, const mjvScene& scene, int pixel) {
  const unsigned char* rgb = &picture.rgb[3 * pixel];
  const int number = rgb[0] + 256 * rgb[1] + 65536 * rgb[2];
  return number == 0 ? -1 : scene.geoms[number - 1].objid;
}
// #endregion

// The mean place of the pixels that show a geom; each is at its middle.
Vector2d centre_of(const Picture& picture, const mjvScene& scene, int geom) {
  Vector2d sum(0, 0);
  int count = 0;
  for (int i = 0; i < kWidth * kHeight; ++i) {
    if (geom_at(picture, scene, i) != geom) continue;
    sum += Vector2d(i % kWidth + 0.5, i / kWidth + 0.5);
    ++count;
  }
  return sum / count;
}

int main() {
  const ScreenlessContext opengl;
  const Model model = load_model("still_life");
  model->vis.quality.offsamples = 0;  // one sample a pixel, at its middle
  const Data data = make_data(model);
  Renderer renderer(model, kWidth, kHeight);
  // #region flags
  renderer.scene.flags[mjRND_SEGMENT] = 1;  // flat colours, no light
  renderer.scene.flags[mjRND_IDCOLOR] = 1;  // and the colour is a number
  // #endregion
  const mjvCamera eye = fixed_camera(model, "eye");
  const int ball = id_of(model, mjOBJ_GEOM, "ball");

  Picture picture;
  std::printf("ball at (m)            computed pixel   in the picture\n");
  double apart = 0;
  for (const Vector3d& moved :
       {Vector3d(0.4, 0, 0), Vector3d(0.4, 1.6, 0), Vector3d(-0.3, -0.4, 0.15),
        Vector3d(0, 0, 0)}) {
    qpos(model, data) = moved;
    mj_forward(model, data);
    picture = renderer.render(data, eye);
    const Vector3d at(data->geom_xpos + 3 * ball);
    const Vector2d pixel = project(model, data, eye.fixedcamid, at);
    const Vector2d seen = centre_of(picture, renderer.scene, ball);
    std::printf("%-22s %7.2f %7.2f  %7.2f %7.2f\n", to_text(at).c_str(),
                pixel.x(), pixel.y(), seen.x(), seen.y());
    apart = std::max(apart, (pixel - seen).norm());
  }
  result("apart", apart);

  std::vector<double> column, row, geom;  // of the last picture
  for (int i = 0; i < kWidth * kHeight; ++i) {
    const int u = i % kWidth, v = i / kWidth;
    const int shown = geom_at(picture, renderer.scene, i);
    if (u % 5 != 2 || v % 5 != 2 || shown < 0) continue;
    column.push_back(u);
    row.push_back(v);
    geom.push_back(shown);
  }
  table("shown", {{"column", column}, {"row", row}, {"geom", geom}});
}
