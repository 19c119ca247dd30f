#include "evaluate/scenes/model_lab.h"

#include <gtest/gtest.h>

#include "evaluate/evaluation_of.h"

namespace mjcourse {
namespace {

constexpr const char* kRig = R"(<mujoco>
  <worldbody><body><joint name="rail" type="slide"/><joint type="ball"/><geom size="0.1"/></body>
  </worldbody>
  <actuator><motor name="push" joint="rail" ctrllimited="true" ctrlrange="1 2"/>
    <motor joint="rail"/></actuator>
  <keyframe><key name="out" qpos="0.25 1 0 0 0"/><key/></keyframe>
</mujoco>
)";

class ModelLabOf {
 public:
  explicit ModelLabOf(const std::string& mjcf)
      : evaluation_("See [it](model:rig).\n", {{"models/rig.xml", mjcf}}) {}

  const ModelPage& page() const { return evaluation_.evaluation().models.at(0); }
  std::string mistakes() const { return evaluation_.mistakes(); }
  const Lesson& lesson() const { return *page().lab->lesson; }

 private:
  EvaluationOf evaluation_;
};

TEST(ModelLab, HasKeyframesActuatorsAndJoints) {
  const ModelLabOf rig(kRig);
  ASSERT_TRUE(rig.page().lab);
  const Lesson& lesson = rig.lesson();
  const Lab& lab = std::get<Lab>(lesson.blocks.at(0));
  EXPECT_EQ(lab.title, "rig, live");
  EXPECT_TRUE(lab.editable);
  ASSERT_EQ(lab.controls.size(), 3U);
  EXPECT_EQ(std::get<Lab::Keyframe>(lab.controls[0]).key.text, "out");
  const auto& push = std::get<Lab::Slider>(lab.controls[1]);
  EXPECT_EQ(push.label.text + " " + push.bind.text, "push data.ctrl[0]");
  EXPECT_EQ(std::vector({push.min, push.max, push.value.value()}), std::vector({1.0, 2.0, 1.0}));
  const auto& other = std::get<Lab::Slider>(lab.controls[2]);
  EXPECT_EQ(other.label.text + " " + other.bind.text, "actuator 1 data.ctrl[1]");
  EXPECT_EQ(std::vector({other.min, other.max}), std::vector({-1.0, 1.0}));
  ASSERT_EQ(lab.readouts.size(), 1U);
  EXPECT_EQ(lab.readouts[0].label.text + " " + lab.readouts[0].expression.text,
            "rail data.qpos[0]");
  EXPECT_EQ(lab.readouts[0].unit, "m");
}

TEST(ModelLab, IsRehearsedLikeAnyOther) {
  const ModelLabOf rig(kRig);
  ASSERT_TRUE(rig.page().lab);
  const LabResult& result = rig.page().lab->result;
  // By itself, at the keyframe, and with each slider at both of its ends.
  ASSERT_EQ(result.runs.size(), 6U);
  EXPECT_EQ(result.runs[1].readings.at(0).values, std::vector({0.25}));
  EXPECT_EQ(result.model.texts.at("rig.xml"), kRig);
}

TEST(ModelLab, LeavesOutWhatTheModelDoesNotBear) {
  // Its keyframe is a pendulum so fast that it leaves the numbers within a step or two.
  const ModelLabOf wild(R"(<mujoco><worldbody>
  <body><joint name="turn" axis="0 1 0"/><geom pos="1 0 0" size="0.1"/></body></worldbody>
  <keyframe><key name="wild" qvel="1e11"/></keyframe></mujoco>
)");
  EXPECT_EQ(wild.mistakes(), "");
  ASSERT_TRUE(wild.page().lab);
  const Lesson& lesson = wild.lesson();
  EXPECT_TRUE(std::get<Lab>(lesson.blocks.at(0)).controls.empty());
}

TEST(ModelLab, IsNotThereForAModelThatCannotBeLeftAlone) {
  const ModelLabOf wild(R"(<mujoco><option gravity="0 0 -1e12"/><worldbody>
  <body><freejoint/><geom size="0.1"/></body></worldbody></mujoco>
)");
  EXPECT_EQ(wild.mistakes(), "");
  EXPECT_FALSE(wild.page().lab);
}

}  // namespace
}  // namespace mjcourse
