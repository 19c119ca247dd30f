// Pictures without a screen: OpenGL in memory, and MuJoCo's renderer in it.
//
//   const ScreenlessContext opengl;  // before any mjr_ function
//   Renderer renderer(model, 320, 240);
//   const Picture picture = renderer.render(data, fixed_camera(model, "eye"));
//
// MuJoCo draws with OpenGL and wants to find a context of it. OSMesa makes one
// without window, screen or graphics card: the processor draws. Debian has it
// as libosmesa6-dev. A program that draws includes GL/osmesa.h itself, too: by
// that line the build knows that it is to be linked with OSMesa.
#pragma once

#include <GL/osmesa.h>

#include <memory>
#include <mjcourse/mjcourse.hpp>
#include <stdexcept>
#include <vector>

namespace mjcourse {

// While it lives, the thread that made it has OpenGL.
class ScreenlessContext {
 public:
  ScreenlessContext()
      : context_(OSMesaCreateContextExt(OSMESA_RGBA, 24, 8, 16, nullptr)) {
    // MuJoCo draws into a buffer of its own; OpenGL wants to see one all the
    // same.
    if (context_ == nullptr ||
        !OSMesaMakeCurrent(context_.get(), pixels_, GL_UNSIGNED_BYTE, 16, 16))
      throw std::runtime_error("OSMesa cannot make an OpenGL context");
  }
  // It stays where it is: OpenGL knows where its pixels are.
  ScreenlessContext(ScreenlessContext&&) = delete;

 private:
  struct Destroy {
    void operator()(OSMesaContext context) const {
      OSMesaDestroyContext(context);
    }
  };
  unsigned char pixels_[4 * 16 * 16] = {};
  std::unique_ptr<osmesa_context, Destroy> context_;
};

// A picture, row after row from the *bottom*, as OpenGL has it.
struct Picture {
  int width, height;
  std::vector<unsigned char> rgb;  // three bytes to a pixel
  std::vector<float> depth;        // 0 at the near plane, 1 at the far one
};

inline mjvCamera fixed_camera(const mjModel* model, const char* name) {
  mjvCamera camera;
  mjv_defaultCamera(&camera);
  camera.type = mjCAMERA_FIXED;
  camera.fixedcamid = id_of(model, mjOBJ_CAMERA, name);
  return camera;
}

// MuJoCo's renderer for one model and one size of pictures.
class Renderer {
 public:
  Renderer(const mjModel* model, int width, int height)
      : model_(model), place_{0, 0, width, height} {
    mjv_defaultOption(&option_);
    mjv_defaultScene(&scene);
    mjr_defaultContext(&context_);
    mjv_makeScene(model, &scene, 1000);  // room for so many geoms
    mjr_makeContext(model, &context_, mjFONTSCALE_100);
    mjr_setBuffer(mjFB_OFFSCREEN, &context_);
  }
  ~Renderer() {
    mjr_freeContext(&context_);
    mjv_freeScene(&scene);
  }
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  // What `camera` sees of `data`, whose results must be up to date.
  Picture render(mjData* data, mjvCamera camera) {
    mjv_updateScene(model_, data, &option_, nullptr, &camera, mjCAT_ALL,
                    &scene);
    mjr_render(place_, &scene, &context_);
    const int pixels = place_.width * place_.height;
    Picture picture{place_.width, place_.height,
                    std::vector<unsigned char>(3 * pixels),
                    std::vector<float>(pixels)};
    mjr_readPixels(picture.rgb.data(), picture.depth.data(), place_, &context_);
    return picture;
  }

  mjvScene scene;  // its flags say how to draw

 private:
  const mjModel* model_;
  mjrRect place_;
  mjvOption option_;
  mjrContext context_;
};

}  // namespace mjcourse
