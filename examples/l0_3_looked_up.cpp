// Lesson 0.3: the knowledge check's answers, looked up in pictures.
//
// INPUT    still_life.xml, seen by its camera "eye"
// PROCESS  draw what each question describes, and read pixels: (1) how wide the
//          crate's front is; (2) in which row the ball is; (3) how far away a
//          wall is where the depth buffer says 0.9; (4) which depth a wall has
//          beside the middle; (5) how far the ball is behind, in a picture that
//          was drawn after mj_step
// OUTPUT   the five numbers; no formula of the lesson enters them, except the one
//          that turns a depth buffer into metres
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l0_3_looked_up

#include <GL/osmesa.h>

#include <cmath>
#include <cstdio>
#include <mjcourse/offscreen.hpp>

using namespace mjcourse;
using Eigen::Vector2d;

double metres(const mjModel* model, double buffer) {
  const double near = model->vis.map.znear * model->stat.extent;
  const double far = model->vis.map.zfar * model->stat.extent;
  return near * far / (far - buffer * (far - near));
}

// The still life, and a renderer with one sample a pixel.
struct Studio {
  explicit Studio(int width, int height)
      : model(load_model("still_life")),
        data((model->vis.quality.offsamples = 0, make_data(model))),
        renderer(model, width, height) {
    mj_forward(model, data);
  }
  Picture take() { return renderer.render(data, fixed_camera(model, "eye")); }

  Model model;
  Data data;
  Renderer renderer;
};

// The crate becomes a wall across the view, so many metres before the eye.
void build_wall(const Studio& studio, double distance) {
  const int crate = id_of(studio.model, mjOBJ_GEOM, "crate");
  mjtNum* size = studio.model->geom_size + 3 * crate;
  size[0] = size[2] = 3;
  size[1] = 0.01;
  mjtNum* place = studio.model->geom_pos + 3 * crate;
  place[0] = 0;
  place[1] = -1.6 + distance + size[1];  // the eye is at -1.6
  mj_forward(studio.model, studio.data);
}

double width_of_front() {
  Studio studio(640, 480);
  studio.model->cam_fovy[0] = 90;
  const Picture picture = studio.take();
  const int row = 212;  // through the front
  int count = 0;
  for (int column = 0; column < 640; ++column) {
    const double z = metres(studio.model, picture.depth[column + 640 * row]);
    count += std::abs(z - 1.7) < 0.001;
  }
  return count;
}

// The mean place of the ball's pixels.
Vector2d ball_in(Studio& studio) {
  studio.renderer.scene.flags[mjRND_SEGMENT] = 1;
  studio.renderer.scene.flags[mjRND_IDCOLOR] = 1;
  const Picture picture = studio.take();
  Vector2d sum(0, 0);
  int count = 0;
  for (int i = 0; i < picture.width * picture.height; ++i) {
    const unsigned char* rgb = &picture.rgb[3 * i];
    const int number = rgb[0] + 256 * rgb[1] + 65536 * rgb[2];
    if (number == 0) continue;
    const mjvGeom& shape = studio.renderer.scene.geoms[number - 1];
    if (shape.objid != id_of(studio.model, mjOBJ_GEOM, "ball")) continue;
    sum += Vector2d(i % picture.width + 0.5, i / picture.width + 0.5);
    ++count;
  }
  return sum / count;
}

double row_of_ball() {
  Studio studio(320, 240);
  qpos(studio.model, studio.data) << 0, 0.4, 0.2;  // m: 2 m away, 0.2 m up
  mj_forward(studio.model, studio.data);
  return ball_in(studio).y();
}

// By bisection: the farther, the larger.
double distance_of(double buffer) {
  Studio studio(320, 240);
  double low = 0.02, high = 1;
  while (high - low > 1e-6) {
    const double middle = (low + high) / 2;
    build_wall(studio, middle);
    const bool nearer = studio.take().depth[160 + 320 * 120] < buffer;
    (nearer ? low : high) = middle;
  }
  return low;
}

double depth_beside_the_middle() {
  Studio studio(320, 240);
  build_wall(studio, 3);
  const int column = 256;  // of a point 1 m to the right
  return metres(studio.model, studio.take().depth[column + 320 * 120]);
}

double columns_behind() {
  Studio studio(320, 240);
  studio.model->opt.timestep = 0.02;
  studio.data->qvel[0] = 5;  // m/s, to the right
  mj_step(studio.model, studio.data);
  const double drawn = ball_in(studio).x();
  mj_forward(studio.model, studio.data);
  return ball_in(studio).x() - drawn;
}

void tell(const char* name, double x, const char* unit) {
  std::printf("%-8s %9.4f %s\n", name, x, unit);
  result(name, x);
}

int main() {
  const ScreenlessContext opengl;
  tell("wide", width_of_front(), "pixels");
  tell("row", row_of_ball(), "");
  tell("wall", distance_of(0.9), "m");
  tell("beside", depth_beside_the_middle(), "m");
  tell("behind", columns_behind(), "pixels");
}
