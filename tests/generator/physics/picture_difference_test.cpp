#include "physics/picture_difference.h"

#include <gtest/gtest.h>

#include <cmath>

#include "physics/renderer.h"
#include "physics/thumbnail.h"

namespace mjcourse {
namespace {

constexpr int kWidth = 90, kHeight = 60;

Picture grey() {
  return {kWidth, kHeight, std::vector<std::uint8_t>(std::size_t{3} * kWidth * kHeight, 120)};
}

void paint(Picture& picture, int x, int y, int side, std::uint8_t red) {
  for (int row = y; row < y + side; ++row) {
    for (int column = x; column < x + side; ++column) {
      picture.rgb[3 * static_cast<std::size_t>(row * kWidth + column)] = red;
    }
  }
}

// Where a picture differs with a square of 4 pixels painted there.
std::string where(int x, int y) {
  Picture picture = grey();
  paint(picture, x, y, 4, 255);
  const PictureDifference difference = compare(grey(), picture);
  EXPECT_FALSE(difference.agrees);
  EXPECT_EQ(difference.pixels, 16U);
  return difference.where;
}

TEST(PictureDifference, IsNoneBetweenEqualPictures) {
  const PictureDifference difference = compare(grey(), grey());
  EXPECT_TRUE(difference.agrees);
  EXPECT_EQ(difference.pixels, 0U);
  EXPECT_EQ(difference.of, 5400U);
  EXPECT_EQ(difference.where, "");
}

TEST(PictureDifference, SaysWhereItIs) {
  EXPECT_EQ(where(2, 2), "mostly in the upper left");
  EXPECT_EQ(where(40, 2), "mostly in the upper middle");
  EXPECT_EQ(where(80, 28), "mostly at the right");
  EXPECT_EQ(where(40, 28), "mostly in the middle");
  EXPECT_EQ(where(80, 50), "mostly in the lower right");
  Picture picture = grey();
  for (const int x : {2, 40, 80}) paint(picture, x, 50, 4, 255);
  EXPECT_EQ(compare(grey(), picture).where, "mostly in its lower third");
  for (const int x : {2, 40, 80}) paint(picture, x, 2, 4, 255);
  for (const int x : {2, 40, 80}) paint(picture, x, 28, 4, 255);
  EXPECT_EQ(compare(grey(), picture).where, "all over it");
}

TEST(PictureDifference, IsShownInVermilion) {
  Picture picture = grey();
  paint(picture, 1, 0, 1, 255);
  const PictureDifference difference = compare(grey(), picture);
  EXPECT_EQ(std::vector(difference.shown.rgb.begin(), difference.shown.rgb.begin() + 6),
            (std::vector<std::uint8_t>{200, 200, 200, 213, 60, 0}));
}

TEST(PictureDifference, ForgivesAFewPixelsAndFaintOnes) {
  Picture stray = grey();
  for (int x = 0; x < 5; ++x) paint(stray, 10 * x, 7, 1, 255);
  EXPECT_TRUE(compare(grey(), stray).agrees);
  paint(stray, 80, 7, 1, 255);
  EXPECT_FALSE(compare(grey(), stray).agrees);
  Picture faint = grey();
  paint(faint, 0, 0, 60, 123);
  EXPECT_TRUE(compare(grey(), faint).agrees);
  paint(faint, 0, 0, 60, 130);
  EXPECT_FALSE(compare(grey(), faint).agrees);
}

// An arm that is turned, an overlay, a colour: what the threshold must see.
class Arm {
 public:
  Picture draw(const Overlays& overlays = {}) {
    simulation_.forward();
    const auto drawn = renderer_.render(simulation_, {90, -10, 2, {0, 0, 0.8}}, overlays);
    return shrink(drawn.value(), 160, 100);
  }
  Simulation& simulation() { return simulation_; }

 private:
  Simulation simulation_{load_model_text(R"(<mujoco><worldbody>
    <light pos="0 -1 3"/><geom type="plane" size="2 2 .1" rgba=".8 .8 .8 1"/>
    <body pos="0 0 1"><joint name="swing" axis="0 1 0"/>
      <geom type="capsule" fromto="0 0 0 0 0 -.5" size=".05" rgba=".7 .3 .1 1"/></body>
    </worldbody></mujoco>)")
                             .value()};
  Renderer renderer_ = Renderer::create().value();
};

TEST(PictureDifference, SeesWhatAReaderWouldSee) {
  Arm arm;
  const Picture reference = arm.draw();
  EXPECT_TRUE(compare(reference, arm.draw()).agrees);
  EXPECT_FALSE(compare(reference, arm.draw({{"frames", true}})).agrees);
  arm.simulation().data()->qpos[0] = M_PI / 180;
  EXPECT_FALSE(compare(reference, arm.draw()).agrees);
  arm.simulation().reset();
  arm.simulation().model()->geom_rgba[4] += 0.1F;
  EXPECT_FALSE(compare(reference, arm.draw()).agrees);
}

}  // namespace
}  // namespace mjcourse
