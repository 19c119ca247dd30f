// Lesson 0.3, challenge: the middle of a ball's picture is not its centre.
//
// INPUT    still_life.xml, its ball off to the side, and ever larger
// PROCESS  find the middle of the ball's pixels; compare it with the pixel of
//          its centre, and with that of the whole outline
// OUTPUT   both differences in pixels; for the lesson, the table "radii"
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l0_3_silhouette

#include <GL/osmesa.h>

#include <cmath>
#include <cstdio>
#include <mjcourse/offscreen.hpp>
#include <vector>

using namespace mjcourse;

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
  const double x = 0.3, depth = 1.6 - 0.6;  // m
  qpos(model, data) << x, -0.6, 0;
  mj_forward(model, data);

  Renderer renderer(model, 640, 480);
  const double half = model->cam_fovy[0] / 2 * M_PI / 180;
  const double f = 240 / std::tan(half), centre = 320 + f * x / depth;
  std::vector<double> radii, measured, formula;
  std::printf("radius (m)  off centre (pixels)  by the formula\n");
  for (const double radius : {0.02, 0.04, 0.06, 0.08, 0.10, 0.12}) {
    model->geom_size[3 * ball] = radius;
    const double off = middle_of(renderer, data, eye, ball) - centre;
    const double outline =
        f * x * depth / (depth * depth - radius * radius) - f * x / depth;
    std::printf("%10.2f  %19.2f  %14.2f\n", radius, off, outline);
    radii.push_back(radius);
    measured.push_back(off);
    formula.push_back(outline);
  }
  table("radii",
        {{"radius", radii}, {"measured", measured}, {"formula", formula}});
  result("largest", measured.back());
}
