#include "evaluate/scenes/svg_names.h"

#include <set>
#include <sstream>
#include <string>

namespace mjcourse {
namespace {

using Names = std::set<std::string, std::less<>>;

Names words_of(const char* text) {
  std::istringstream words(text);
  Names names;
  for (std::string word; words >> word;) names.insert(word);
  return names;
}

// Without those that hold a script or foreign content, lead somewhere (`a`), load something
// (`feImage`) or move (`animate`, `set`).
constexpr const char* kElements = R"(
  svg g defs symbol use title desc style image
  path rect circle ellipse line polyline polygon text tspan textPath
  marker pattern mask clipPath linearGradient radialGradient stop
  filter feBlend feColorMatrix feComponentTransfer feComposite feConvolveMatrix feDiffuseLighting
  feDisplacementMap feDistantLight feDropShadow feFlood feFuncA feFuncB feFuncG feFuncR
  feGaussianBlur feMerge feMergeNode feMorphology feOffset fePointLight feSpecularLighting
  feSpotLight feTile feTurbulence
)";

constexpr const char* kAttributes = R"(
  version baseProfile
  id class style lang xml:lang xml:space role type media href xlink:href
  viewBox preserveAspectRatio x y width height x1 y1 x2 y2 cx cy r rx ry fx fy fr d points
  pathLength dx dy rotate textLength lengthAdjust startOffset method spacing side
  transform transform-origin gradientUnits gradientTransform spreadMethod offset clipPathUnits
  maskUnits maskContentUnits patternUnits patternContentUnits patternTransform
  markerUnits markerWidth markerHeight refX refY orient
  filterUnits primitiveUnits in in2 result stdDeviation values mode operator k1 k2 k3 k4 order
  kernelMatrix kernelUnitLength divisor bias targetX targetY edgeMode preserveAlpha scale
  xChannelSelector yChannelSelector baseFrequency numOctaves seed stitchTiles surfaceScale
  diffuseConstant specularConstant specularExponent azimuth elevation z pointsAtX pointsAtY
  pointsAtZ limitingConeAngle radius tableValues slope intercept amplitude exponent
  alignment-baseline baseline-shift clip-path clip-rule color color-interpolation
  color-interpolation-filters direction display dominant-baseline enable-background fill
  fill-opacity fill-rule filter flood-color flood-opacity font-family font-size font-size-adjust
  font-stretch font-style font-variant font-weight image-rendering isolation letter-spacing
  lighting-color marker-end marker-mid marker-start mask mask-type mix-blend-mode opacity overflow
  paint-order shape-rendering stop-color stop-opacity stroke stroke-dasharray stroke-dashoffset
  stroke-linecap stroke-linejoin stroke-miterlimit stroke-opacity stroke-width text-anchor
  text-decoration text-rendering unicode-bidi vector-effect visibility white-space word-spacing
  writing-mode
)";

}  // namespace

bool is_svg_element(std::string_view name) {
  static const Names names = words_of(kElements);
  return names.contains(name);
}

bool is_svg_attribute(std::string_view name) {
  static const Names names = words_of(kAttributes);
  return names.contains(name) || name.starts_with("aria-") || name.starts_with("data-");
}

}  // namespace mjcourse
