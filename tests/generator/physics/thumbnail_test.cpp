#include "physics/thumbnail.h"

#include <gtest/gtest.h>

namespace mjcourse {
namespace {

using Bytes = std::vector<std::uint8_t>;

// A row of grey pixels.
Picture row_of(const Bytes& greys) {
  Picture row{static_cast<int>(greys.size()), 1, {}};
  for (const std::uint8_t grey : greys) row.rgb.insert(row.rgb.end(), 3, grey);
  return row;
}

TEST(Thumbnail, IsTheMeanOfWhatEachPixelStandsFor) {
  const Picture small = shrink({2, 2, {0, 0, 0, 40, 0, 0, 0, 8, 0, 40, 0, 100}}, 1, 1);
  EXPECT_EQ(small.width, 1);
  EXPECT_EQ(small.height, 1);
  EXPECT_EQ(small.rgb, (Bytes{20, 2, 25}));
}

// Three pixels become two: the middle one counts half in each.
TEST(Thumbnail, SharesPixelsThatLieInTwo) {
  EXPECT_EQ(shrink(row_of({0, 90, 30}), 2, 1).rgb, row_of({30, 50}).rgb);
}

TEST(Thumbnail, OfTheSameSizeIsThePictureItself) {
  const Picture row = row_of({0, 255, 7});
  EXPECT_EQ(shrink(row, 3, 1).rgb, row.rgb);
}

}  // namespace
}  // namespace mjcourse
