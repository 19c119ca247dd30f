#include "evaluate/scenes/model_page.h"

#include <gtest/gtest.h>

#include "evaluate/evaluation_of.h"

namespace mjcourse {
namespace {

constexpr const char* kRigModel = R"(<mujoco>
  <include file="parts/rail.xml"/>
  <actuator><motor name="push" joint="rail" ctrllimited="true" ctrlrange="-2 2"/></actuator>
  <sensor><jointpos name="place" joint="rail"/><framepos objtype="site" objname="tip"/></sensor>
  <keyframe><key name="out" time="0.5" qpos="0 0 0 1 0 0 0 0.25"/><key/></keyframe>
</mujoco>
)";
constexpr const char* kRail = R"(<mujoco><worldbody>
  <body name="ball" pos="0 0 1"><freejoint/><geom size="0.1"/></body>
  <body name="cart"><joint name="rail" type="slide" limited="true" range="0 0.5"/>
    <geom size="0.1"/><site name="tip"/></body>
</worldbody></mujoco>
)";

class ModelPageOf {
 public:
  ModelPageOf()
      : evaluation_("See [it](model:rig) and [it](model:rig).\n",
                    {{"models/rig.xml", kRigModel}, {"models/parts/rail.xml", kRail}}) {}
  const ModelPage& page() const { return evaluation_.evaluation().models.at(0); }

 private:
  EvaluationOf evaluation_;
};

TEST(ModelPage, TellsWhatTheModelIsMadeOf) {
  const ModelPageOf rig;
  const ModelPage& page = rig.page();
  std::string text = page.name + ", " + page.timestep + " s:";
  for (const auto& [name, count] : page.sizes) text += " " + name + " " + std::to_string(count);
  EXPECT_EQ(text, "rig, 0.002 s: nq 8 nv 7 nu 1 nbody 3 njnt 2 ngeom 2 nsensor 2 nkey 2");

  ASSERT_EQ(page.joints.size(), 2U);
  EXPECT_EQ(page.joints[0].name + " " + page.joints[0].type + " " + page.joints[0].body,
            "joint 0 free ball");
  const ModelPage::Joint& rail = page.joints[1];
  EXPECT_EQ(rail.name + " " + rail.type + " " + rail.limits, "rail slide 0 … 0.5 m");
  EXPECT_EQ(std::vector({rail.qpos.first, rail.qpos.count, rail.dof.first, rail.dof.count}),
            std::vector({7, 1, 6, 1}));

  EXPECT_EQ(
      page.actuators.at(0).name + ", " + page.actuators[0].on + ", " + page.actuators[0].limits,
      "push, joint rail, −2 … 2");
  EXPECT_EQ(page.sensors.at(0).name + ", " + page.sensors[0].of, "place, joint rail");
  EXPECT_EQ(page.sensors.at(1).name + ", " + page.sensors[1].of, "sensor 1, site tip");
  EXPECT_EQ(page.sensors[1].data.first + 10 * page.sensors[1].data.count, 31);
  EXPECT_EQ(page.keyframes.at(0).name + " " + page.keyframes[0].time, "out 0.5");
  EXPECT_EQ(page.keyframes.at(1).name, "key 1");
}

TEST(ModelPage, HasThePictureAndTheFiles) {
  const ModelPageOf rig;
  const ModelPage& page = rig.page();
  ASSERT_EQ(page.files.size(), 2U);
  EXPECT_EQ(page.files[0].path + " " + page.files[1].path, "models/rig.xml models/parts/rail.xml");
  EXPECT_EQ(page.files[0].text, kRigModel);
  EXPECT_EQ(page.files[1].text, kRail);
  EXPECT_TRUE(page.poster.webp.bytes().starts_with("RIFF"));
  EXPECT_GT(page.poster.width * page.poster.height, 0);
}

TEST(ModelPage, IsMadeForLinkedModelsOnly) {
  EXPECT_TRUE(EvaluationOf("Nothing.\n").evaluation().models.empty());
}

TEST(ModelPage, NeedsAModelThatCompiles) {
  const EvaluationOf broken("See [it](model:rig).\n",
                            {{"models/rig.xml", "<mujoco><geom/></mujoco>"}});
  EXPECT_TRUE(broken.evaluation().models.empty());
  ASSERT_EQ(broken.diagnostics().size(), 1U);
  EXPECT_EQ(broken.diagnostics()[0].id, "E-model-mjcf");
}

TEST(ModelPage, NeedsMjcfThatItCanShow) {
  EXPECT_EQ(EvaluationOf("See [it](model:rig).\n",
                         {{"models/rig.xml", "<!-- \xff --><mujoco><worldbody/></mujoco>"}})
                .mistakes(),
            "models/rig.xml:1:1: error: a model's file is in UTF-8 [E-model-mjcf]\n"
            "  1 | <!-- \xFF --><mujoco><worldbody/></mujoco>\n"
            "    | ^~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~\n"
            "  note: content/1-a/1.1-x.md:4:16: lesson content/1-a/1.1-x.md uses this model\n"
            "  4 | See [it](model:rig).\n"
            "    |                ^~~\n"
            "  cure: save it in UTF-8\n");
}

}  // namespace
}  // namespace mjcourse
