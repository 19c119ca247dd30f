#include "evaluate/code_names.h"

#include <gtest/gtest.h>

namespace mjcourse {
namespace {

const MujocoApi& api() {
  return installed_mujoco_api().value();
}

// "mj_step 1 3, mjData.qpos 2".
std::string names_of(const std::string& code) {
  std::string text;
  for (const auto& [name, lines] : names_in_code(code, api())) {
    text += (text.empty() ? "" : ", ") + name;
    for (const int line : lines) text += " " + std::to_string(line);
  }
  return text;
}

TEST(CodeNames, AreFunctionsTypesAndConstants) {
  EXPECT_EQ(names_of("mj_step(a, b);\nfor (mjtNum x : y) mj_step(a, b);\nint t = mjJNT_FREE;\n"),
            "mjJNT_FREE 3, mj_step 1 2, mjtNum 2");
  EXPECT_EQ(names_of("mj_stop(); my_mj_step(); mj_stepper();"), "");
}

TEST(CodeNames, AreFieldsOfWhatIsDeclared) {
  EXPECT_EQ(names_of("const mjData* now = f();\nnow->qpos[0] = now->time;\n"),
            "mjData 1, mjData.qpos 2, mjData.time 2");
  EXPECT_EQ(names_of("const Data fresh = make_data(x);\nfresh->qvel[0] = 1;\n"), "mjData.qvel 2");
  EXPECT_EQ(names_of("const mjContact& one = all[i];\nif (one.dist < 0) return;\n"),
            "mjContact 1, mjContact.dist 2");
  EXPECT_EQ(names_of("Recording r;\nr.qpos = 1;\nr.time = 2;\n"), "");
}

TEST(CodeNames, AreFieldsOfWhatEverybodyCallsSo) {
  EXPECT_EQ(names_of("model->nq + data->qpos[model->jnt_qposadr[2]]"),
            "mjData.qpos 1, mjModel.jnt_qposadr 1, mjModel.nq 1");
  EXPECT_EQ(names_of("model.nq + data.qpos[13] // in a script"), "mjData.qpos 1, mjModel.nq 1");
}

TEST(CodeNames, FollowChains) {
  EXPECT_EQ(names_of("model->opt.timestep"), "mjModel.opt 1, mjOption.timestep 1");
  EXPECT_EQ(names_of("data->contact[data->ncon - 1].dist"),
            "mjContact.dist 1, mjData.contact 1, mjData.ncon 1");
  EXPECT_EQ(names_of("model->vis.global.fovy"), "mjModel.vis 1, mjVisual.global.fovy 1");
  EXPECT_EQ(names_of("run.data->qvel[0]; run.model.get()->nv"), "mjData.qvel 1, mjModel.nv 1");
}

TEST(CodeNames, AreTakenBehindAnArrowWhereOneStructureHasThem) {
  EXPECT_EQ(names_of("plan_->qpos"), "mjData.qpos 1");
  EXPECT_EQ(names_of("plan_->nothing; plan_->buffer"), "") << "both have a buffer";
}

TEST(CodeNames, PassOverCommentsAndStrings) {
  EXPECT_EQ(names_of("// mj_step\n/* mj_step\n*/ \"mj_step \\\" mj_step\" 'mj_step' mj_forward();"),
            "mj_forward 3");
  EXPECT_EQ(names_of("R\"(<mujoco> mj_step \" )\"; 1'000'000; R\"x(\n)\" )x\"; mj_forward();"),
            "mj_forward 2");
}

TEST(CodeNames, AreFoundInWhateverIsThere) {
  for (const char* code : {"", "[", "]", "model->", "model.[", "R\"", "\"", "/*", "model->opt.",
                           "a[b[c[", "1'", "const mjData*", "'\\"}) {
    EXPECT_NO_THROW(names_of(code)) << code;
  }
}

}  // namespace
}  // namespace mjcourse
