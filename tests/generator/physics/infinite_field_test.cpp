#include "physics/infinite_field.h"

#include <gtest/gtest.h>

#include <limits>

namespace mjcourse {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

Model ball() {
  return load_model_text("<mujoco><worldbody><body><geom size='1'/></body></worldbody></mujoco>")
      .value();
}

TEST(InfiniteField, IsNoneOfASaneModel) {
  Model model = ball();
  EXPECT_EQ(find_infinite_field(model), "");
}

TEST(InfiniteField, IsNamedWithItsIndex) {
  Model model = ball();
  model->body_pos[4] = -kInfinite;
  EXPECT_EQ(find_infinite_field(model), "body_pos[4]");
}

TEST(InfiniteField, OfASingleNumberHasNone) {
  Model model = ball();
  model->opt.timestep = kInfinite;
  EXPECT_EQ(find_infinite_field(model), "opt.timestep");
}

TEST(InfiniteField, MayBeOfFloats) {
  Model model = ball();
  model->geom_rgba[2] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(find_infinite_field(model), "geom_rgba[2]");
}

}  // namespace
}  // namespace mjcourse
