// An OpenGL context without a screen, drawn on by the CPU (OSMesa).
//
// It brings OpenGL's state and a tiny default buffer; MuJoCo draws into a framebuffer object of its
// own, of any size.
// Tested by tests/generator/physics/renderer_test.cpp.
#pragma once

#include <GL/osmesa.h>

#include <memory>
#include <vector>

#include "base/late_library.h"

namespace mjcourse {

// The functions that are used of a library that the first call loads.
#define MJCOURSE_LATE(name) \
  inline const LateFunction<kOffscreenGraphics, decltype(::name)> name(#name)
MJCOURSE_LATE(OSMesaCreateContextAttribs);
MJCOURSE_LATE(OSMesaDestroyContext);
MJCOURSE_LATE(OSMesaMakeCurrent);
MJCOURSE_LATE(glGetIntegerv);
#undef MJCOURSE_LATE

class OffscreenContext {
 public:
  OffscreenContext();

  // Makes this the calling thread's OpenGL context. False when OSMesa could not make one.
  bool make_current();

 private:
  struct Delete {
    void operator()(OSMesaContext context) const { OSMesaDestroyContext(context); }
  };
  std::vector<unsigned char> buffer_;  // RGBA
  std::unique_ptr<osmesa_context, Delete> context_;
};

}  // namespace mjcourse
