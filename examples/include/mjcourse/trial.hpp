// What the programs of lesson 5.1 try again and again: pick_place.xml with its
// objects somewhere else each time, and the arm of arm.hpp taking one of them
// to the tray.
//
//   std::mt19937 random(1);  // the same starts on every machine
//   const Trial trial(draw(random), model);
//   if (trial.carry(0.6).placed) ...
#pragma once

#include <mjcourse/arm.hpp>
#include <random>

namespace mjcourse {

struct Start {
  Eigen::Vector2d at[3];   // of the cube, the carton and the ball, m
  double yaw[3];           // rad
  int which;               // the one to take, by its place in kHolds
  double mass, friction;   // of that one; kg
  Eigen::Vector2d camera;  // so far beside it the camera sees it, m
};

// By hand, since the standard leaves open how its distributions draw.
inline double between(double low, double high, std::mt19937& random) {
  return low + (high - low) * (static_cast<double>(random()) / 4294967296.0);
}
inline double normal(std::mt19937& random) {  // by Box and Muller
  const double radius = std::sqrt(-2 * std::log(1 - between(0, 1, random)));
  return radius * std::cos(between(0, 2 * M_PI, random));
}

inline Start draw(std::mt19937& random) {
  Start start;
  for (int i = 0; i < 3; ++i) {
    bool fits;
    do {
      const double x = between(0.4, 0.7, random);
      start.at[i] = {x, between(-0.34, 0.06, random)};
      fits = start.at[i].norm() < 0.68;  // within the arm's reach
      for (int j = 0; j < i; ++j)        // and with room for the hand
        fits = fits && (start.at[i] - start.at[j]).norm() > 0.16;
    } while (!fits);
    start.yaw[i] = between(-M_PI / 2, M_PI / 2, random);
  }
  start.which = static_cast<int>(between(0, 3, random));
  start.mass = between(0.05, 0.6, random);
  start.friction = between(0.2, 1.2, random);
  start.camera[0] = 0.004 * normal(random);
  start.camera[1] = 0.004 * normal(random);
  return start;
}

inline Data set_up(const Start& start, mjModel* model) {
  Data data = make_data(model);
  const char* name = kHolds[start.which].object;
  const int body = id_of(model, mjOBJ_BODY, name);
  const double factor = start.mass / model->body_mass[body];
  model->body_mass[body] *= factor;
  for (int k = 0; k < 3; ++k) model->body_inertia[3 * body + k] *= factor;
  // MuJoCo takes the larger coefficient of two geoms, so all three get it.
  for (const char* geom : {name, "finger_left_pad", "finger_right_pad"})
    model->geom_friction[3 * id_of(model, mjOBJ_GEOM, geom)] = start.friction;
  mj_setConst(model, data);  // what follows from the mass; puts qpos0 into data

  mj_resetDataKeyframe(model, data, id_of(model, mjOBJ_KEY, "home"));
  for (int i = 0; i < 3; ++i) {
    const int joint = id_of(model, mjOBJ_JOINT, kHolds[i].object);
    double* q = data->qpos + model->jnt_qposadr[joint];
    mju_copy(q, start.at[i].data(), 2);
    const double up[] = {0, 0, 1};
    mju_axisAngle2Quat(q + 3, up, start.yaw[i]);
  }
  mj_forward(model, data);
  return data;
}

struct Outcome {
  double room;    // beside the object for the nearer finger, on its way down, m
  double could;   // the most that friction can carry, felt before the lift, N
  double weight;  // N
  bool placed;    // in the tray
};

// A start up to the moment at which the fingers, still open, are around the
// object. From there it can be carried again and again.
class Trial {
 public:
  Trial(const Start& start, const mjModel* base)
      : start_(start),
        model_(mj_copyModel(nullptr, base)),
        data_(set_up(start, model_)),
        grasp_(pose_for(kHolds[start.which], model_, data_)),
        arm_(model_, data_) {
    grasp_.position.head<2>() += start.camera;
    arm_.move(raised(grasp_, 0.14), 0.8);
    arm_.move(grasp_, 0.6);
  }

  // Closes the fingers, waits `patience` seconds for them, and takes what they
  // hold to the tray.
  Outcome carry(double patience) const {
    const Data data(mj_copyData(nullptr, model_, data_));
    Arm arm(arm_, data);
    const Hold& hold = kHolds[start_.which];
    const double* at = data->xpos + 3 * id_of(model_, mjOBJ_BODY, hold.object);
    const double* felt = data->sensordata;  // by the two pads, N

    const Eigen::Vector3d fingers =
        grasp_.orientation * Eigen::Vector3d::UnitY();
    const double aside = std::abs(fingers.head<2>().dot(start_.camera));
    Outcome outcome{kOpen - hold.half_width - aside, 0,
                    start_.mass * -model_->opt.gravity[2], false};

    const double rest = at[2];
    arm.grip(0);
    arm.wait(patience);
    outcome.could = start_.friction * (felt[0] + felt[1]);
    arm.move(raised(grasp_, 0.16), 0.6);
    if (at[2] < rest + 0.02) return outcome;  // left behind

    // 12 mm: the tray's floor, and a gap of 4 mm.
    const Pose tray{{0.62, 0.28, grasp_.position[2] + 0.012}, pointing_down(0)};
    arm.move(raised(tray, 0.15), 1.0);
    arm.move(tray, 0.5);
    arm.grip(0.04);
    arm.wait(0.3);
    arm.move(raised(tray, 0.15), 0.5);
    outcome.placed = std::abs(at[0] - 0.62) < 0.12 &&
                     std::abs(at[1] - 0.28) < 0.09 && at[2] < 0.48;
    return outcome;
  }

 private:
  Start start_;
  Model model_;
  Data data_;
  Pose grasp_;
  Arm arm_;
};

}  // namespace mjcourse
