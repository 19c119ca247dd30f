// Lesson 0.3: pixels are measurements.
//
// INPUT    still_life.xml, seen by its camera "eye"
// PROCESS  (1) work out at which pixel the ball's centre is, and find it in the
//          picture of object numbers; (2) turn the depth buffer into metres
// OUTPUT   both, for some places of the ball; the depths of four surfaces
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l0_3_measure

#include <GL/osmesa.h>

#include <cmath>
#include <cstdio>
#include <mjcourse/offscreen.hpp>
#include <string>
#include <vector>

using namespace mjcourse;
using Eigen::Vector2d, Eigen::Vector3d;
using RowMatrix3d = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

constexpr int kWidth = 320, kHeight = 240;

// #region project
// The pixel of a point, from the lower left corner; z is its depth in metres.
Vector3d project(const mjModel* model, const mjData* data, int camera,
                 const Vector3d& point) {
  const Vector3d eye(data->cam_xpos + 3 * camera);
  const Eigen::Map<const RowMatrix3d> axes(data->cam_xmat + 9 * camera);
  const Vector3d seen = axes.transpose() * (point - eye);
  const double depth = -seen.z();  // cameras look along their own -z
  const double half = model->cam_fovy[camera] / 2 * M_PI / 180;
  const double f = kHeight / 2 / std::tan(half);  // in pixels
  return {kWidth / 2 + f * seen.x() / depth, kHeight / 2 + f * seen.y() / depth,
          depth};
}
// #endregion

// #region ids
// At each pixel the geom that is seen there, or -1.
std::vector<int> geom_ids(Renderer& renderer, mjData* data,
                          const mjvCamera& camera) {
  renderer.scene.flags[mjRND_SEGMENT] = 1;  // flat colours, no light
  renderer.scene.flags[mjRND_IDCOLOR] = 1;  // and the colour is a number
  const Picture picture = renderer.render(data, camera);
  renderer.scene.flags[mjRND_SEGMENT] = 0;
  renderer.scene.flags[mjRND_IDCOLOR] = 0;

  std::vector<int> ids(picture.depth.size(), -1);
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const unsigned char* rgb = &picture.rgb[3 * i];
    const int number = rgb[0] + 256 * rgb[1] + 65536 * rgb[2] - 1;
    for (int g = 0; g < renderer.scene.ngeom; ++g) {
      const mjvGeom& geom = renderer.scene.geoms[g];
      if (geom.segid == number && geom.objtype == mjOBJ_GEOM)
        ids[i] = geom.objid;
    }
  }
  return ids;
}
// #endregion

// The mean place of the pixels that show a geom; each is at its middle.
Vector2d centre_of(const std::vector<int>& ids, int geom) {
  Vector2d sum = Vector2d::Zero();
  int count = 0;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    if (ids[i] != geom) continue;
    sum += Vector2d(i % kWidth + 0.5, i / kWidth + 0.5);
    ++count;
  }
  return sum / count;
}

// #region metres
double metres(const mjModel* model, double buffer) {
  const double near = model->vis.map.znear * model->stat.extent;
  const double far = model->vis.map.zfar * model->stat.extent;
  return near * far / (far - buffer * (far - near));
}
// #endregion

int main() {
  const ScreenlessContext opengl;
  const Model model = load_model("still_life");
  model->vis.quality.offsamples = 0;  // one sample a pixel, at its middle
  const Data data = make_data(model);
  Renderer renderer(model, kWidth, kHeight);
  const mjvCamera eye = fixed_camera(model, "eye");
  const int ball = id_of(model, mjOBJ_GEOM, "ball");

  std::printf("ball at (m)            computed pixel   in the picture\n");
  double apart = 0;
  for (const Vector3d& place :
       {Vector3d(0, 0, 0), Vector3d(0.4, 0, 0), Vector3d(0.4, 1.6, 0),
        Vector3d(-0.3, -0.4, 0.15)}) {
    qpos(model, data) = place;
    mj_forward(model, data);
    const Vector3d centre(data->geom_xpos + 3 * ball);
    const Vector3d pixel = project(model, data, eye.fixedcamid, centre);
    const Vector2d seen = centre_of(geom_ids(renderer, data, eye), ball);
    std::printf("%-22s %7.2f %7.2f  %7.2f %7.2f\n", to_text(centre).c_str(),
                pixel.x(), pixel.y(), seen.x(), seen.y());
    if (place == Vector3d(0.4, 0, 0)) result("right_column", pixel.x());
    apart = std::max(apart, (pixel.head<2>() - seen).norm());
  }
  result("apart", apart);

  qpos(model, data).setZero();
  mj_forward(model, data);
  const Picture picture = renderer.render(data, eye);
  const auto compare = [&](const char* what, int column, int row, double z) {
    const float buffer = picture.depth[column + kWidth * row];
    const double found = metres(model, buffer);
    std::printf("%-18s  %.4f m    %.6f  %.4f m\n", what, z, buffer, found);
    result(what + std::string("_um"), 1e6 * std::abs(found - z));
  };
  const double f = kHeight / 2 / std::tan(model->cam_fovy[0] / 2 * M_PI / 180);
  std::printf("surface             by hand     buffer    as metres\n");
  compare("ball", 160, 120, 1.6 - 0.08);
  compare("crate", 92, 86, 1.6 + 0.25 - 0.15);
  compare("floor", 160, 20, f * 0.35 / (kHeight / 2 - 20.5));

  const double near = metres(model, 0);
  result("step_um", 1e6 * 1.7 * 1.7 / near / (1 << 24));  // dz, for db = 2^-24

  const std::vector<int> ids = geom_ids(renderer, data, eye);
  std::vector<double> x, y, z, geom, at, buffer;
  for (int row = 2; row < kHeight; row += 5) {
    for (int column = 2; column < kWidth; column += 5) {
      const int i = column + kWidth * row;
      if (ids[i] < 0) continue;  // sky
      x.push_back(column);
      y.push_back(row);
      z.push_back(metres(model, picture.depth[i]));
      geom.push_back(ids[i]);
    }
  }
  table("pixels", {{"column", x}, {"row", y}, {"metres", z}, {"geom", geom}});
  for (double b = 0; b < 0.998; b += b < 0.95 ? 0.01 : 0.001) {
    buffer.push_back(b);
    at.push_back(metres(model, b));
  }
  table("buffer", {{"metres", at}, {"buffer", buffer}});
  result("half", metres(model, 0.5));
}
