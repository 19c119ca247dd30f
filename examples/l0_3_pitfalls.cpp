// Lesson 0.3: three pictures that are not what they should be.
//
// INPUT    still_life.xml, seen by its camera "eye"
// PROCESS  (1) look at the first and the last row; (2) move the ball without
//          mj_forward; (3) ask for more pixels than there are
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
    result("first_row", depth_of_row(0));
    result("last_row", depth_of_row(239));

    // #region stale
    const auto differ = [&] {
      return renderer.render(data, eye).rgb != picture.rgb;
    };
    data->qpos[0] = 0.3;  // m
    std::printf("moved, not forward: %s\n", differ() ? "differs" : "the same");
    mj_forward(model, data);
    std::printf("moved, and forward: %s\n", differ() ? "differs" : "the same");
    // #endregion
  }

  // #region large
  Renderer large(model, 800, 600);
  const Picture picture = large.render(data, eye);
  const auto is_black = [&](int column, int row) {
    const unsigned char* rgb = &picture.rgb[3 * (column + 800 * row)];
    return rgb[0] + rgb[1] + rgb[2] == 0;
  };
  std::printf("buffer: %d x %d\n", model->vis.global.offwidth,
              model->vis.global.offheight);
  std::printf("pixel (600, 400): %s\n", is_black(600, 400) ? "black" : "drawn");
  std::printf("pixel (700, 500): %s\n", is_black(700, 500) ? "black" : "drawn");
  // #endregion
}
