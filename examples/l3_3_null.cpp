// Lesson 3.3: a torque that moves the elbow, and a hand that ought to stay.
//
// INPUT    planar_arm.xml, at rest; 0.1 N m at the elbow
// PROCESS  take out of that torque what moves the hand: with the pseudoinverse,
//          and with the dynamically consistent inverse; read the accelerations;
//          then apply it for 0.6 s, alone, and besides a controller of the hand
// OUTPUT   how the hand and the elbow accelerate, and how far they move; for
//          the lesson, the table "wander" and snapshots
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l3_3_null

#include <cmath>
#include <cstdio>
#include <mjcourse/mjcourse.hpp>
#include <string>
#include <vector>

#include "l3_3_hand.hpp"

using namespace mjcourse;
using Eigen::Matrix2d, Eigen::Matrix3d, Eigen::Vector2d, Eigen::Vector3d;

const Vector3d kTorque(0, 0.1, 0);  // N m, at the elbow

// #region projections
using Projection = Matrix3d (*)(const Hand&);

Matrix3d all_of_it(const Hand&) {
  return Matrix3d::Identity();
}

// What is left of a torque without its part along the rows of J.
Matrix3d with_pseudoinverse(const Hand& hand) {
  const auto& J = hand.J;
  const Matrix2d square = J * J.transpose();
  return Matrix3d::Identity() - J.transpose() * square.inverse() * J;
}

// What is left of a torque without its part that accelerates the hand.
Matrix3d consistent(const Hand& hand) {
  const auto& J = hand.J;
  const Matrix3d inverse = hand.M.inverse();
  const Matrix2d lambda = (J * inverse * J.transpose()).inverse();
  const Eigen::Matrix<double, 3, 2> bar = inverse * J.transpose() * lambda;
  return Matrix3d::Identity() - J.transpose() * bar.transpose();
}
// #endregion

// #region hold
// The torque that keeps the hand at home.
Vector3d hold(const Hand& hand, const Vector2d& home) {
  const auto& J = hand.J;
  const Matrix2d lambda = (J * hand.M.inverse() * J.transpose()).inverse();
  const Vector2d wanted = 100 * (home - hand.x) - 20 * hand.v;
  return hand.c + J.transpose() * lambda * (wanted - hand.drift);
}
// #endregion

struct Moved {
  double hand = 0, elbow = 0;  // m, at most; rad
};

Moved move(const Model& model, const Data& data, Projection project, bool held,
           std::vector<double>& path) {
  const Data scratch = make_data(model);
  mj_resetData(model, data);
  mj_forward(model, data);
  const Vector2d home = hand_of(model, data, scratch).x;
  const double elbow = data->qpos[1];
  Moved moved;
  for (int step = 0; step <= 300; ++step) {
    mj_step1(model, data);
    const Hand hand = hand_of(model, data, scratch);
    Vector3d torque = project(hand) * kTorque;
    if (held) torque += hold(hand, home);
    ctrl(model, data) = torque;
    moved.hand = std::max(moved.hand, (hand.x - home).norm());
    if (step % 5 == 0) path.push_back(1000 * (hand.x - home).norm());
    if (step == 300) break;
    mj_step2(model, data);
  }
  moved.elbow = data->qpos[1] - elbow;
  return moved;
}

int main() {
  const Model model = load_model("planar_arm");
  const Data data = make_data(model), scratch = make_data(model);
  const int sensor = id_of(model, mjOBJ_SENSOR, "hand_acceleration");
  const struct {
    const char *label, *name;
    Projection project;
  } kinds[] = {{"all of it", "all", all_of_it},
               {"pseudoinverse", "pseudo", with_pseudoinverse},
               {"consistent", "consistent", consistent}};

  std::printf("%-14s  torques (N m)              hand    elbow\n", "at rest");
  for (const auto& kind : kinds) {
    mj_resetData(model, data);
    mj_forward(model, data);
    const Hand hand = hand_of(model, data, scratch);
    ctrl(model, data) = kind.project(hand) * kTorque;
    mj_forward(model, data);
    const Vector2d a(data->sensordata + model->sensor_adr[sensor]);
    std::printf("%-14s  %7.4f %7.4f %7.4f %7.3f %8.2f\n", kind.label,
                data->ctrl[0], data->ctrl[1], data->ctrl[2], a.norm(),
                data->qacc[1]);
    result(kind.name + std::string("_hand"), a.norm());
    result(kind.name + std::string("_elbow"), data->qacc[1]);
  }
  std::printf("%-14s  %s\n", "in 0.6 s", "hand (mm)  elbow (degrees)");
  std::vector<double> time, paths[4];
  for (int step = 0; step <= 300; step += 5) time.push_back(0.002 * step);
  for (const bool held : {false, true}) {
    for (int i = 1; i < 3; ++i) {
      const Moved moved =
          move(model, data, kinds[i].project, held, paths[2 * held + i - 1]);
      std::printf("%-14s  %9.2f  %15.1f%s\n", kinds[i].label, 1000 * moved.hand,
                  moved.elbow * 180 / M_PI, held ? "  hand held" : "");
      const std::string name = kinds[i].name + std::string(held ? "_held" : "");
      result(name + "_mm", 1000 * moved.hand);
      result(name + "_turned", moved.elbow * 180 / M_PI);
      if (held) snapshot(kinds[i].name, model, data);
    }
  }
  table("wander", {{"time", time},
                   {"pseudoinverse", paths[0]},
                   {"consistent", paths[1]},
                   {"pseudoinverse, hand held", paths[2]},
                   {"consistent, hand held", paths[3]}});
}
