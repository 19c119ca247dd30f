// What the programs of lesson 3.3 share: all that a controller has to know of
// the hand of planar_arm.xml, for one state.
//
//   mj_step1(model, data);
//   const Hand hand = hand_of(model, data, scratch);
//   torque = hand.J.transpose() * force;  // as in lesson 1.4
#pragma once

#include <mjcourse/mjcourse.hpp>

namespace mjcourse {

struct Hand {
  Eigen::Matrix<double, 2, 3> J;  // from joint speeds to the hand's, x and y
  Eigen::Matrix3d M;              // the mass matrix
  Eigen::Vector3d c;              // the bias force
  Eigen::Vector2d x, v;           // where the hand is, and its velocity
  Eigen::Vector2d drift;          // how J changes, times the joint speeds
};

// The data's positions must be up to date.
inline Eigen::Matrix<double, 2, 3> jacobian_of(const mjModel* model,
                                               const mjData* data) {
  Eigen::Matrix<double, 3, 3, Eigen::RowMajor> all;
  mj_jacSite(model, data, all.data(), nullptr,
             id_of(model, mjOBJ_SITE, "hand"));
  return all.topRows<2>();
}

// After mj_step1 or mj_forward; `scratch` is data of its own.
inline Hand hand_of(const mjModel* model, mjData* data, mjData* scratch) {
  Hand hand;
  hand.J = jacobian_of(model, data);
  mj_fullM(model, hand.M.data(), data->qM);  // symmetric: rows or columns
  hand.c = Eigen::Vector3d(data->qfrc_bias);
  hand.x =
      Eigen::Vector2d(data->site_xpos + 3 * id_of(model, mjOBJ_SITE, "hand"));
  hand.v = hand.J * qvel(model, data);

  const double moment = 1e-6;  // s
  mju_copy(scratch->qpos, data->qpos, model->nq);
  mj_integratePos(model, scratch->qpos, data->qvel, moment);
  mj_kinematics(model, scratch);
  mj_comPos(model, scratch);
  hand.drift =
      (jacobian_of(model, scratch) - hand.J) / moment * qvel(model, data);
  return hand;
}

}  // namespace mjcourse
