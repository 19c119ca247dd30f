#include "physics/thumbnail.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace mjcourse {
namespace {

// A pixel of the small picture covers these pixels of the large one, the outer two in part.
struct Cover {
  double begin, end;
  Cover(int index, int small, int large)
      : begin(static_cast<double>(index) * large / small),
        end(static_cast<double>(index + 1) * large / small) {}
  int first() const { return static_cast<int>(begin); }
  int last() const { return static_cast<int>(std::ceil(end)); }
  // How much of pixel `at` is covered.
  double share(int at) const { return std::min(end, at + 1.0) - std::max(begin, double(at)); }
};

}  // namespace

Picture shrink(const Picture& picture, int width, int height) {
  Picture small{width, height, {}};
  for (int y = 0; y < height; ++y) {
    const Cover rows(y, height, picture.height);
    for (int x = 0; x < width; ++x) {
      const Cover columns(x, width, picture.width);
      std::array<double, 3> sum{};
      double area = 0;
      for (int row = rows.first(); row < rows.last(); ++row) {
        for (int column = columns.first(); column < columns.last(); ++column) {
          const double share = rows.share(row) * columns.share(column);
          const int at = 3 * (row * picture.width + column);
          const std::uint8_t* rgb = picture.rgb.data() + at;
          for (std::size_t c = 0; c < 3; ++c) sum[c] += share * rgb[c];
          area += share;
        }
      }
      for (const double value : sum) {
        small.rgb.push_back(static_cast<std::uint8_t>(std::lround(value / area)));
      }
    }
  }
  return small;
}

}  // namespace mjcourse
