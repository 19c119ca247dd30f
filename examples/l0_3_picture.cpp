// Lesson 0.3: a picture is a function of the state.
//
// INPUT    still_life.xml, seen by its camera "eye"; no screen
// PROCESS  (1) draw; (2) move the ball, and draw; (3) put it back, and draw
// OUTPUT   which of the pictures have the same bytes, and how many pixels
//          differ; the first picture as picture.ppm
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l0_3_picture

#include <GL/osmesa.h>

#include <cstdio>
#include <fstream>
#include <memory>
#include <mjcourse/offscreen.hpp>
#include <vector>

using namespace mjcourse;
using Bytes = std::vector<unsigned char>;

// Calls a mjv_ or mjr_ function that frees, when its scope ends.
template <typename T>
using Freed = std::unique_ptr<T, void (*)(T*)>;

constexpr int kWidth = 320, kHeight = 240;

int changed_pixels(const Bytes& a, const Bytes& b) {
  int count = 0;
  for (std::size_t i = 0; i < a.size(); i += 3)
    count += a[i] != b[i] || a[i + 1] != b[i + 1] || a[i + 2] != b[i + 2];
  return count;
}

int main() {
  const ScreenlessContext opengl;
  const Model model = load_model("still_life");
  const Data data = make_data(model);

  // #region make
  mjvScene scene;  // what is to be drawn: a list of geoms, lights, a camera
  mjv_defaultScene(&scene);
  mjv_makeScene(model, &scene, 100);
  const Freed<mjvScene> scene_freed(&scene, mjv_freeScene);

  mjrContext context;  // what OpenGL keeps: meshes, textures, pixels
  mjr_defaultContext(&context);
  mjr_makeContext(model, &context, mjFONTSCALE_100);
  const Freed<mjrContext> context_freed(&context, mjr_freeContext);
  mjr_setBuffer(mjFB_OFFSCREEN, &context);
  // #endregion

  // #region draw
  mjvOption option;
  mjv_defaultOption(&option);
  mjvCamera camera = fixed_camera(model, "eye");
  const mjrRect whole{0, 0, kWidth, kHeight};

  const auto picture = [&] {
    mj_forward(model, data);  // where everything is, from qpos
    mjv_updateScene(model, data, &option, nullptr, &camera, mjCAT_ALL, &scene);
    mjr_render(whole, &scene, &context);
    Bytes rgb(3 * kWidth * kHeight);
    mjr_readPixels(rgb.data(), nullptr, whole, &context);
    return rgb;
  };
  // #endregion

  const Bytes first = picture();
  snapshot("first", model, data);
  qpos(model, data) << 0.3, -0.4, 0.15;  // right, nearer, up: in metres
  const Bytes moved = picture();
  snapshot("moved", model, data);
  qpos(model, data).setZero();
  const Bytes back = picture();

  const int changed = changed_pixels(first, moved);
  std::printf("geoms in the scene: %d\n", scene.ngeom);
  std::printf("ball moved:    %5d of %d pixels differ\n", changed,
              kWidth * kHeight);
  std::printf("ball put back: %5d\n", changed_pixels(first, back));
  result("changed", changed);

  std::ofstream file("picture.ppm");
  file << "P6 " << kWidth << ' ' << kHeight << " 255\n";
  for (int row = kHeight - 1; row >= 0; --row)  // the top one comes first
    file.write(reinterpret_cast<const char*>(&first[3 * kWidth * row]),
               3 * kWidth);
}
