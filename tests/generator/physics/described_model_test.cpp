#include "physics/described_model.h"

#include <gtest/gtest.h>

#include "physics/model.h"

namespace mjcourse {
namespace {

Model build(const DescribedJoints& joints) {
  auto model = load_model_text(described_mjcf(joints));
  EXPECT_TRUE(model.has_value()) << model.error().message;
  return std::move(model.value());
}

TEST(DescribedModel, HasTheSizesOfItsJoints) {
  const Model hinge = build({.hinge = 1});
  EXPECT_EQ(hinge->nq, 1);
  EXPECT_EQ(hinge->nv, 1);
  const Model ball = build({.ball = 1});
  EXPECT_EQ(ball->nq, 4);
  EXPECT_EQ(ball->nv, 3);
  const Model mixed = build({.hinge = 7, .slide = 2, .ball = 3, .free = 2});
  EXPECT_EQ(mixed->nq, 7 + 2 + 3 * 4 + 2 * 7);
  EXPECT_EQ(mixed->nv, 7 + 2 + 3 * 3 + 2 * 6);
  EXPECT_EQ(mixed->njnt, 14);
}

TEST(DescribedModel, MayHaveNoJointAtAll) {
  const Model none = build({});
  EXPECT_EQ(none->nq, 0);
  EXPECT_EQ(none->njnt, 0);
}

TEST(DescribedModel, NamesJointsInTheOrderFreeBallSlideHinge) {
  const Model model = build({.hinge = 2, .slide = 1, .ball = 1, .free = 1});
  EXPECT_EQ(model.names(mjOBJ_JOINT),
            (std::vector<std::string>{"free0", "ball0", "slide0", "hinge0", "hinge1"}));
}

}  // namespace
}  // namespace mjcourse
