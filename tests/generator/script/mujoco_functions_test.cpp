// MuJoCo's functions as scripts call them (site/press/script/mujoco-functions.ts and their native
// half).
#include <nlohmann/json.hpp>

#include "world_fixture.h"

namespace mjcourse {

class MujocoFunctionsTest : public WorldTest {
 protected:
  // The numbers that `script` leaves in `result`.
  std::vector<double> result(const std::string& script) {
    const auto value = world_.value(Program{script, 0, "result"});
    if (!value) ADD_FAILURE() << script << ": " << shown(value.error());
    return value ? value->get<std::vector<double>>() : std::vector<double>{};
  }
};

TEST_F(MujocoFunctionsTest, DifferentiateUndoesIntegrate) {
  EXPECT_EQ(result("const q0 = data.qpos.slice(), q1 = data.qpos.slice();"
                   "const v = new Array(model.nv).fill(0); v[4] = 2;"
                   "mj_integratePos(model, q1, v, 0.5);"
                   "const w = new Float64Array(model.nv);"
                   "mj_differentiatePos(model, w, 0.5, q0, q1);"
                   "const result = [...w].map((x) => Math.round(x * 1e9) / 1e9)"),
            std::vector<double>({0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0}));
}

TEST_F(MujocoFunctionsTest, Quaternions) {
  EXPECT_EQ(result("const result = [9, 9, 9, 9]; mju_mulQuat(result, [0, 1, 0, 0], [0, 0, 1, 0])"),
            std::vector<double>({0, 0, 0, 1}));
  EXPECT_EQ(result("const result = [9, 9, 9, 9]; mju_negQuat(result, [0, 1, 0, 0])"),
            std::vector<double>({0, -1, 0, 0}));
  EXPECT_EQ(result("const result = [9, 9, 9]; mju_rotVecQuat(result, [0, 1, 2], [0, 1, 0, 0])"),
            std::vector<double>({0, -1, -2}));
  EXPECT_EQ(result("const result = [0, 0, 5, 0], n = mju_normalize4(result); result.push(n)"),
            std::vector<double>({0, 0, 1, 0, 5}));
  EXPECT_EQ(result("const result = [9, 9, 9, 9]; mju_axisAngle2Quat(result, [1, 0, 0], 0)"),
            std::vector<double>({1, 0, 0, 0}));
  EXPECT_EQ(result("const q = [1, 0, 0, 0]; mju_quatIntegrate(q, [0, 0, 1], 0.25);"
                   "const r = [0, 0, 0]; mju_quat2Vel(r, q, 0.25);"
                   "const s = [0, 0, 0]; mju_subQuat(s, q, [1, 0, 0, 0]);"
                   "const result = [...r, ...s].map((x) => Math.round(x * 1e9) / 1e9)"),
            std::vector<double>({0, 0, 1, 0, 0, 0.25}));
}

TEST_F(MujocoFunctionsTest, WorksOnMujocosOwnMemory) {
  ASSERT_TRUE(world_.run("mju_negQuat(data.qpos.subarray(3, 7), [0, 1, 0, 0])"));
  EXPECT_EQ(simulation_.data()->qpos[4], -1);
  ASSERT_TRUE(world_.run("mj_integratePos(model, data.qpos, data.qvel.fill(1), 0.5)"));
  EXPECT_EQ(simulation_.data()->qpos[12], 0.5);
}

TEST_F(MujocoFunctionsTest, OnTheWholeWorld) {
  ASSERT_TRUE(world_.run("mj_step(model, data); mj_step(model, data)"));
  EXPECT_DOUBLE_EQ(simulation_.data()->time, 0.004);
  ASSERT_TRUE(world_.run("mj_resetData(model, data); mj_forward(model, data)"));
  EXPECT_EQ(simulation_.data()->time, 0);
  ASSERT_TRUE(world_.run("mj_energyPos(model, data); mj_energyVel(model, data)"));
  EXPECT_NE(simulation_.data()->energy[0], 0);
  EXPECT_EQ(number("(() => { const m = new Array(model.nv).fill(0), v = [...m]; v[0] = 1;"
                   "mj_mulM(model, data, m, v); return m[0]; })()"),
            2);
}

TEST_F(MujocoFunctionsTest, ObjectVelocity) {
  EXPECT_EQ(result("data.qvel[2] = 3; forward(); const result = new Array(6).fill(9);"
                   "mj_objectVelocity(model, data, mjOBJ_BODY, 1, result, 0)"),
            std::vector<double>({0, 0, 0, 0, 0, 3}));
}

TEST_F(MujocoFunctionsTest, ArgumentsAreChecked) {
  EXPECT_EQ(run_error("mj_differentiatePos(model, [], 0.1, data.qpos, data.qpos)"),
            "E-script-range 1:1+19 mj_differentiatePos: qvel has 0 numbers, expected nv = 11 | ");
  EXPECT_EQ(run_error("mj_differentiatePos(model, data.qvel, 0.1, data.qvel, data.qpos)"),
            "E-script-range 1:1+19 mj_differentiatePos: qpos1 has 11 numbers, expected nq = 13 | ");
  EXPECT_EQ(run_error("mj_step(data, model)"),
            "E-script-value 1:1+7 mj_step: its model must be `model`, not an object | ");
  EXPECT_EQ(run_error("mju_negQuat([0, 0, 0, 0])"),
            "E-script-value 1:1+11 mju_negQuat: wants 2 (res, quat) arguments, not 1 | ");
  EXPECT_EQ(run_error("mju_negQuat([0, 0, 0, 0], [1, 0, NaN, 0])"),
            "E-script-value 1:1+11 mju_negQuat: quat[2] is NaN, not a finite number | "
            "look for a division by 0, or a root or a logarithm of a negative number");
  EXPECT_EQ(run_error("mju_negQuat(5, [1, 0, 0, 0])"),
            "E-script-value 1:1+11 mju_negQuat: res must be an array, not 5 | ");
  EXPECT_EQ(run_error("mju_quatIntegrate([1, 0, 0, 0], [0, 0, 1], '1')"),
            "E-script-value 1:1+17 mju_quatIntegrate: scale must be a finite number, not \"1\" | ");
  EXPECT_EQ(run_error("mj_objectVelocity(model, data, mjOBJ_BODY, 5, new Array(6).fill(0), 0)"),
            "E-script-range 1:1+17 mj_objectVelocity: objid is 5: out of range 0..4 | ");
  EXPECT_EQ(run_error("mj_objectVelocity(model, data, mjOBJ_JOINT, 0, new Array(6).fill(0), 0)"),
            "E-script-value 1:1+17 mj_objectVelocity: objtype must be mjOBJ_BODY, _XBODY, _GEOM, "
            "_SITE or _CAMERA | ");
  EXPECT_EQ(run_error("mj_objectVelocity(model, data, mjOBJ_BODY, 0.5, [0, 0, 0, 0, 0, 0], 0)"),
            "E-script-value 1:1+17 mj_objectVelocity: objid must be a whole number, not 0.5 | ");
}

}  // namespace mjcourse
