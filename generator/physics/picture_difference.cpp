#include "physics/picture_difference.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace mjcourse {
namespace {

constexpr double kDiffers = 0.011;     // between two colours, in OKLab
constexpr std::size_t kMostStray = 5;  // pixels that differ in pictures that agree

using Colour = std::array<double, 3>;

double linear(std::uint8_t value) {
  const double c = value / 255.0;
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

// Björn Ottosson, "A perceptual color space for image processing", 2020.
Colour oklab(const std::uint8_t* rgb) {
  const double r = linear(rgb[0]), g = linear(rgb[1]), b = linear(rgb[2]);
  const double l = std::cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
  const double m = std::cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
  const double s = std::cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
  return {0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s,
          1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
          0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s};
}

double distance(const Colour& a, const Colour& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

// How many pixels differ in each third of the picture, across or down.
using Thirds = std::array<std::size_t, 3>;

// The third with most of them, 0 to 2; -1 where they are all over.
int foremost(const Thirds& thirds) {
  const auto most = std::max_element(thirds.begin(), thirds.end());
  const bool most_of_them = 5 * *most >= 3 * (thirds[0] + thirds[1] + thirds[2]);
  return most_of_them ? static_cast<int>(most - thirds.begin()) : -1;
}

std::string place_in_words(const Thirds& across, const Thirds& down) {
  const int column = foremost(across), row = foremost(down);
  if (row < 0 && column < 0) return "all over it";
  const auto of = [](int third, const std::array<std::string, 3>& words) {
    return "mostly " + words[static_cast<std::size_t>(third)];
  };
  if (row < 0) return of(column, {"at its left", "down its middle", "at its right"});
  if (column < 0) return of(row, {"in its upper third", "across its middle", "in its lower third"});
  if (row == 1) return of(column, {"at the left", "in the middle", "at the right"});
  const std::string part = row == 0 ? "in the upper " : "in the lower ";
  return of(column, {part + "left", part + "middle", part + "right"});
}

// What agrees is paled, so that what does not stands out.
void show(const std::uint8_t* rgb, bool differs, Picture& shown) {
  const int grey = (54 * rgb[0] + 183 * rgb[1] + 19 * rgb[2]) / 256;
  const auto pale = static_cast<std::uint8_t>(170 + grey / 4);
  if (differs) {
    shown.rgb.insert(shown.rgb.end(), {213, 60, 0});
  } else {
    shown.rgb.insert(shown.rgb.end(), {pale, pale, pale});
  }
}

}  // namespace

PictureDifference compare(const Picture& reference, const Picture& actual) {
  PictureDifference difference;
  difference.shown = {actual.width, actual.height, {}};
  difference.of = actual.rgb.size() / 3;
  const auto width = static_cast<std::size_t>(actual.width);
  Thirds across{}, down{};
  for (std::size_t i = 0; i < difference.of; ++i) {
    const std::uint8_t* rgb = &actual.rgb[3 * i];
    const bool differs = distance(oklab(&reference.rgb[3 * i]), oklab(rgb)) > kDiffers;
    show(rgb, differs, difference.shown);
    if (!differs) continue;
    ++difference.pixels;
    ++across[3 * (i % width) / width];
    ++down[3 * (i / width) / static_cast<std::size_t>(actual.height)];
  }
  difference.agrees = difference.pixels <= kMostStray;
  if (difference.pixels > 0) difference.where = place_in_words(across, down);
  return difference;
}

}  // namespace mjcourse
