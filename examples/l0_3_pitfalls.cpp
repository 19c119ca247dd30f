// Lesson 0.3: four pictures that are not what they should be.
//
// INPUT    still_life.xml, seen by its camera "eye"
// PROCESS  (1) look at the first and the last row; (2) move the ball without
//          mj_forward; (3) ask for more pixels than there are; (4) read the
//          depth of a picture with smooth edges
// OUTPUT   what each of them shows
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l0_3_pitfalls

#include <GL/osmesa.h>

#include <cstdio>
#include <mjcourse/offscreen.hpp>

using namespace mjcourse;

int main() {
  const ScreenlessContext opengl;
  const Model model = load_model("still_life");
  const Data data = make_data(model);
  const mjvCamera eye = fixed_camera(model, "eye");
  mj_forward(model, data);

  {
    Renderer renderer(model, 320, 240);
    // #region rows
    const Picture picture = renderer.render(data, eye);
    const auto depth_of_row = [&](int row) {
      return picture.depth[picture.width * row];
    };
    std::printf("row   0: depth %.3f\n", depth_of_row(0));
    std::printf("row 239: depth %.3f\n", depth_of_row(239));
    // #endregion

    // #region stale
    const auto show = [&](const char* when) {
      const bool same = renderer.render(data, eye).rgb == picture.rgb;
      std::printf("%s: %s\n", when, same ? "the same" : "differs");
    };
    data->qpos[0] = 0.3;  // m
    show("moved, not forward");
    mj_forward(model, data);
    show("moved, and forward");
    // #endregion
  }

  {
    // #region large
    Renderer renderer(model, 800, 600);
    const Picture picture = renderer.render(data, eye);
    const auto show = [&](int column, int row) {
      const unsigned char* rgb = &picture.rgb[3 * (column + 800 * row)];
      std::printf("pixel (%d, %d): %s\n", column, row,
                  rgb[0] + rgb[1] + rgb[2] == 0 ? "black" : "drawn");
    };
    show(600, 400);
    show(700, 500);
    // #endregion
  }

  // #region samples
  const double near = model->vis.map.znear * model->stat.extent;
  const double far = model->vis.map.zfar * model->stat.extent;
  for (const int samples : {4, 0}) {
    model->vis.quality.offsamples = samples;
    Renderer renderer(model, 320, 240);
    const float b = renderer.render(data, eye).depth[160 + 320 * 20];
    std::printf("floor in row 20, %d samples: %.4f m\n", samples,
                near * far / (far - b * (far - near)));
  }
  // #endregion
}
