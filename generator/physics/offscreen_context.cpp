#include "physics/offscreen_context.h"

#include <array>

namespace mjcourse {
namespace {

constexpr int buffer_side = 16;  // pixels; nothing is drawn here

// What MuJoCo's renderer asks of a context: the fixed pipeline, and the buffers that it looks for.
constexpr std::array<int, 13> attributes = {OSMESA_FORMAT,
                                            OSMESA_RGBA,
                                            OSMESA_DEPTH_BITS,
                                            24,
                                            OSMESA_STENCIL_BITS,
                                            8,
                                            OSMESA_ACCUM_BITS,
                                            16,
                                            OSMESA_PROFILE,
                                            OSMESA_COMPAT_PROFILE,
                                            0};

}  // namespace

OffscreenContext::OffscreenContext()
    : buffer_(std::size_t{buffer_side} * buffer_side * 4),
      context_(OSMesaCreateContextAttribs(attributes.data(), nullptr)) {}

bool OffscreenContext::make_current() {
  return context_ != nullptr && OSMesaMakeCurrent(context_.get(), buffer_.data(), GL_UNSIGNED_BYTE,
                                                  buffer_side, buffer_side) == GL_TRUE;
}

}  // namespace mjcourse
