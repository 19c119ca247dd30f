// Lesson 1.2: generalized coordinates, and why positions are not velocities.
//
// INPUT    joint_zoo.xml: one free, one ball, one slide and one hinge joint
// PROCESS  (1) print where each joint lives in qpos and in qvel;
//          (2) spin the free body, then recover its velocity from two poses
//              by naive differencing and by mj_differentiatePos;
//          (3) integrate a pose with mj_integratePos and check the norm of
//              its quaternion
// OUTPUT   the layout table and the two velocity estimates side by side
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l1_2_generalized_coordinates

#include <cmath>
#include <cstdio>
#include <mjcourse/mjcourse.hpp>

using namespace mjcourse;
using Eigen::VectorXd;

// By mjtJoint.
constexpr const char* kTypeNames[] = {"free", "ball", "slide", "hinge"};

void layout(const Model& model) {
  std::printf("nq = %d, nv = %d\n", model->nq, model->nv);
  for (int j = 0; j < model->njnt; ++j) {
    const bool last = j + 1 == model->njnt;
    const int qadr = model->jnt_qposadr[j], vadr = model->jnt_dofadr[j];
    const int qend = last ? model->nq : model->jnt_qposadr[j + 1];
    const int vend = last ? model->nv : model->jnt_dofadr[j + 1];
    std::printf("  %-6s (%-5s) qpos[%d:%d] size %d   qvel[%d:%d] size %d\n",
                mj_id2name(model, mjOBJ_JOINT, j),
                kTypeNames[model->jnt_type[j]], qadr, qend, qend - qadr, vadr,
                vend, vend - vadr);
  }
}

void recover_velocity(const Model& model) {
  const Data data = make_data(model);
  const int joint = id_of(model, mjOBJ_JOINT, "free");
  const int a = model->jnt_qposadr[joint], b = model->jnt_dofadr[joint];
  const VectorXd q0 = qpos(model, data);

  // Spin the free body: 2 rad/s about its local z axis, plus 0.1 m/s along
  // world x.
  qvel(model, data).segment<6>(b) << 0.1, 0, 0, 0, 0, 2.0;
  const VectorXd true_v = qvel(model, data);
  const double dt = 0.05;
  const long steps = std::lround(dt / model->opt.timestep);
  for (long i = 0; i < steps; ++i) mj_step(model, data);
  const VectorXd q1 = qpos(model, data);

  // The naive estimate has length nq: for free and ball joints it is not a
  // velocity at all.
  const VectorXd naive = (q1 - q0) / dt;
  VectorXd proper(model->nv);
  mj_differentiatePos(model, proper.data(), dt, q0.data(), q1.data());

  print("free joint, true qvel           :", true_v.segment<6>(b));
  print("mj_differentiatePos(dt, q0, q1)  :", proper.segment<6>(b));
  print("naive (q1 - q0) / dt, 7 numbers  :", naive.segment<7>(a));
  result("naive_qz", naive[a + 6]);  // for the lesson's text to quote
}

void integrate_pose(const Model& model) {
  const Data data = make_data(model);
  const int joint = id_of(model, mjOBJ_JOINT, "free");
  VectorXd q = qpos(model, data);  // a copy: the state itself stays as it is
  VectorXd v = VectorXd::Zero(model->nv);
  // Its angular velocity, rad/s, for half a second.
  v.segment<3>(model->jnt_dofadr[joint] + 3) = Eigen::Vector3d(1, 2, 3);
  mj_integratePos(model, q.data(), v.data(), 0.5);
  const Eigen::Vector4d quat = q.segment<4>(model->jnt_qposadr[joint] + 3);
  std::printf("after mj_integratePos: quaternion = %s  norm = %s\n",
              to_text(quat).c_str(), to_text(quat.norm(), 12).c_str());
}

int main() {
  const Model model = load_model("joint_zoo");
  layout(model);
  recover_velocity(model);
  integrate_pose(model);
}
