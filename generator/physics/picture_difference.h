// How much two pictures differ to the eye.
//
// The same scene drawn on another kind of CPU is not the same to the bit. Measured with Mesa's own
// switches on pictures of the course's models, drawn at 1280 x 800 and shrunken to 160 x 100. The
// number is the greatest distance of a pixel in OKLab, in which black and white are 1 apart:
//
//   legitimate   LP_NATIVE_VECTOR_WIDTH=128, GALLIUM_OVERRIDE_CPU_CAPS=avx      0.0000
//                GALLIUM_OVERRIDE_CPU_CAPS=sse4.1, DRAW_USE_LLVM=0              0.0036
//                GALLIUM_OVERRIDE_CPU_CAPS=sse, sse2, sse3                      0.0055
//   real         a joint turned by one degree, a limb of 20 pixels   13 pixels over 0.01
//                the same, a limb of 50 pixels                       41 to 90 pixels
//                a geom moved by 1 cm                                16 to 125 pixels
//                an overlay off, or another on                       9 to 300 pixels, of up to 0.8
//                a geom's red changed by 0.2                         8 to 3500 pixels
//
// So a pixel differs from twice the legitimate distance on, and pictures differ where more than
// five pixels do. One that flips at an edge of the picture as drawn is a sixty-fourth of a pixel
// here. What stays unseen is what a reader would not see either: a gripper far away that turns by
// one degree. Another rasterizer (GALLIUM_DRIVER=softpipe) smooths edges otherwise, with up to 140
// pixels over 0.01, and counts as a difference.
#pragma once

#include <cstddef>
#include <string>

#include "physics/picture.h"

namespace mjcourse {

struct PictureDifference {
  std::size_t pixels = 0;  // that differ, of so many:
  std::size_t of = 0;
  std::string where;  // "mostly in the upper left", "all over it"; empty where nothing differs
  Picture shown;      // grey, and vermilion where they differ
  bool agrees = true;
};

// The two have the same size.
PictureDifference compare(const Picture& reference, const Picture& actual);

}  // namespace mjcourse
