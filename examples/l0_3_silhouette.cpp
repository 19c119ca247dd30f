// Lesson 0.3, challenge: the middle of a ball's picture is not its centre.
//
// INPUT    still_life.xml, its ball off to the side, and ever larger
// PROCESS  find the middle of the ball's pixels; compare it with the pixel of
//          its centre, and with that of the whole outline
// OUTPUT   both differences in pixels; for the lesson, the table "radii";
//          checks the formula against pictures, also of another ball
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l0_3_silhouette

#include <GL/osmesa.h>

#include <cmath>
#include <cstdio>
#include <mjcourse/offscreen.hpp>
#include <vector>

using namespace mjcourse;

// Where the middle of a ball's outline is in the picture: how many pixels to
// the right of the picture's middle. The ball's centre is `x` to the right of
// the camera's axis, at the camera's height, and has the depth `z`; `radius` is
// less than `z` (all in m). A pixel is one unit wide at the distance `f`.
double outline_middle(double f, double x, double z, double radius) {
  // #region answer
  return f * x * z / (z * z - radius * radius);
  // #starter
  // return 0;  // the mean of the pixels of two rays, which touch the ball
  // #wrong pixel-of-the-centre: the middle is where the picture shows it
  // return f * x / z;
  // #wrong nearest-point: the middle is where the picture shows it
  // return f * x / (z - radius);
  // #wrong leg-for-hypotenuse: the middle is where the picture shows it
  // const double theta = std::atan2(x, z), alpha = std::atan2(radius, z);
  // return f / 2 * (std::tan(theta + alpha) + std::tan(theta - alpha));
  // #wrong tangent-for-sine: another ball follows the same formula
  // const double alpha = std::atan(radius / std::hypot(x, z));
  // const double theta = std::atan2(x, z);
  // return f / 2 * (std::tan(theta + alpha) + std::tan(theta - alpha));
  // #wrong first-order: another ball follows the same formula
  // return f * x / z * (1 + radius * radius / (z * z));
  // #wrong distance-for-depth: a small ball is where its centre is
  // return f * x * z / (x * x + z * z - radius * radius);
  // #wrong fitted: another ball follows the same formula
  // return f * x / z + 177 * radius * radius;
  // #endregion
}

// The mean column of the pixels that show a geom; each is at its middle.
double middle_of(Renderer& renderer, mjData* data, const mjvCamera& camera,
                 int geom) {
  renderer.scene.flags[mjRND_SEGMENT] = 1;
  renderer.scene.flags[mjRND_IDCOLOR] = 1;
  const Picture picture = renderer.render(data, camera);
  int number = -1;
  for (int g = 0; g < renderer.scene.ngeom; ++g)
    if (renderer.scene.geoms[g].objid == geom)
      number = renderer.scene.geoms[g].segid + 1;

  double sum = 0;
  int count = 0;
  for (std::size_t i = 0; i < picture.depth.size(); ++i) {
    if (picture.rgb[3 * i] != number) continue;  // few geoms: red is enough
    sum += i % picture.width + 0.5;
    ++count;
  }
  return sum / count;
}

int main() {
  const ScreenlessContext opengl;
  const Model model = load_model("still_life");
  model->vis.quality.offsamples = 0;
  model->vis.quality.numslices = 200;  // a ball is drawn as a polyhedron
  model->vis.quality.numstacks = 100;
  const Data data = make_data(model);
  const mjvCamera eye = fixed_camera(model, "eye");
  const int ball = id_of(model, mjOBJ_GEOM, "ball");
  Renderer renderer(model, 640, 480);
  const double half = model->cam_fovy[0] / 2 * M_PI / 180;
  const double f = 240 / std::tan(half);
  // By the picture, from the picture's middle.
  const auto shown = [&](double x, double z, double radius) {
    qpos(model, data) << x, z - 1.6, 0;  // the eye is at y = -1.6 m
    mj_forward(model, data);
    model->geom_size[3 * ball] = radius;
    return middle_of(renderer, data, eye, ball) - 320;
  };

  const double x = 0.3, z = 1, centre = f * x / z;  // m, m, pixels
  bool is_right = expect_near(outline_middle(f, x, z, 1e-9), centre, 1e-6,
                              "a small ball is where its centre is",
                              "for a point, only the perspective is left");
  std::vector<double> radii, measured, formula;
  std::printf("radius (m)  off centre (pixels)  by the formula\n");
  for (const double radius : {0.02, 0.04, 0.06, 0.08, 0.10, 0.12}) {
    const double off = shown(x, z, radius) - centre;
    const double outline = outline_middle(f, x, z, radius) - centre;
    std::printf("%10.2f  %19.2f  %14.2f\n", radius, off, outline);
    radii.push_back(radius);
    measured.push_back(off);
    formula.push_back(outline);
    is_right = is_right &&
               expect_near(outline, off, 0.1,
                           "the middle is where the picture shows it",
                           "both edges count, and each has a ray of its own");
  }
  table("radii",
        {{"radius", radii}, {"measured", measured}, {"formula", formula}});
  result("largest", measured.back());
  if (is_right)
    expect_near(outline_middle(f, -0.2, 1, 0.3), shown(-0.2, 1, 0.3), 0.2,
                "another ball follows the same formula",
                "it fits small balls only: is the angle at the point of "
                "contact a right one?");
}
