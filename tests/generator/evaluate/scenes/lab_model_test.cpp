#include "evaluate/scenes/lab_model.h"

#include <gtest/gtest.h>

#include "evaluate/scenes/lab_text.h"

namespace mjcourse {
namespace {

constexpr const char* kWedge =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

TEST(LabModel, IsWhatThePageNeeds) {
  const EvaluationOf found(
      lab_text("\"readouts\": []", "arm"),
      {{"models/arm.xml", "<mujoco><include file='a/w.xml'/><worldbody/></mujoco>"},
       {"models/a/w.xml", "<mujoco><asset><mesh file='a/w.obj'/></asset></mujoco>"},
       {"models/a/w.obj", kWedge}});
  EXPECT_EQ(found.mistakes(), "");
  const LabModel& model = found.result<LabResult>().model;
  EXPECT_EQ(model.main, "arm.xml");
  EXPECT_EQ(model.texts.at("arm.xml"), "<mujoco><include file='a/w.xml'/><worldbody/></mujoco>");
  EXPECT_EQ(model.texts.size(), 2U);
  EXPECT_EQ(model.assets.at("w.obj").filename(), "w.obj");
}

TEST(LabModel, MayStandInTheLesson) {
  const EvaluationOf found(lab_text("\"readouts\": []", "<mujoco/>"));
  EXPECT_EQ(found.mistakes(), "");
  const LabModel& model = found.result<LabResult>().model;
  EXPECT_EQ(model.main, "model.xml");
  EXPECT_EQ(model.texts.at("model.xml"), "<mujoco/>");
}

TEST(LabModel, HasFilesThatThePageCanTellApart) {
  EXPECT_EQ(
      rehearsed_mistakes("\"readouts\": []",
                         {{"models/arm.xml",
                           "<mujoco><asset><mesh name='a' file='a/w.obj'/>"
                           "<mesh name='b' file='b/w.obj'/></asset></mujoco>"},
                          {"models/a/w.obj", kWedge},
                          {"models/b/w.obj", kWedge}},
                         "arm"),
      "E-lab-files <arm> two files of the model are named w.obj, and the page finds a file by its "
      "name alone | rename a file, or leave one out\n");
}

}  // namespace
}  // namespace mjcourse
