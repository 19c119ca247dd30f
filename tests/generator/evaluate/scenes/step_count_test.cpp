#include "evaluate/scenes/step_count.h"

#include <gtest/gtest.h>

namespace mjcourse {
namespace {

tl::expected<int, std::string> steps(double time_step, double seconds) {
  auto model = load_model_text("<mujoco/>").value();
  model->opt.timestep = time_step;
  return step_count(model, seconds);
}

TEST(StepCount, ComesNearestToTheTime) {
  EXPECT_EQ(steps(0.002, 2), 1000);
  EXPECT_EQ(steps(0.002, 0), 0);
  EXPECT_EQ(steps(0.1, 0.26), 3);
  EXPECT_EQ(steps(0.1, 0.24), 2);
  // 0.3 / 0.1 is a little less than 3 in a double.
  EXPECT_EQ(steps(0.1, 0.3), 3);
}

TEST(StepCount, IsAMillionAtMost) {
  EXPECT_EQ(steps(0.001, 1000), kMostSteps);
  EXPECT_EQ(steps(0.001, 1001).error(),
            "the time step is 0.001 s, so 1001 s are more than a million steps");
  EXPECT_EQ(steps(1e-9, 2).error(),
            "the time step is 1e-09 s, so 2 s are more than a million steps");
}

}  // namespace
}  // namespace mjcourse
