// Lesson 3.1: four ways to hold an arm with servos, and what they need to know.
//
// INPUT    arm_and_crate.xml, whose two servos pull with 60 and 30 N m/rad; a
//          pose in which the arm leans away from the crate
// PROCESS  hold it by the servos alone, with an offset of their targets, with
//          gravity compensation anew in every step, and with an integral;
//          then make the real forearm heavier than the model says
// OUTPUT   the errors at rest
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l3_1_feed_forward

#include <cstdio>
#include <mjcourse/mjcourse.hpp>
#include <string>

using namespace mjcourse;
using Eigen::Vector2d, Eigen::VectorXd;

// The arm's joints are the last two of the model: tail<2>().
const Vector2d kTarget(-1.2, -0.8);  // rad
const Vector2d kStiffness(60, 30);   // N m/rad, of the servos

// #region weight
// What the joints must supply to stand still in `pose`, as `model` has it.
Vector2d weight(const Model& model, const Data& scratch, const VectorXd& pose) {
  mj_resetData(model, scratch);  // at rest
  qpos(model, scratch) = pose;
  mj_fwdPosition(model, scratch);
  mj_fwdVelocity(model, scratch);
  VectorXd torque(model->nv);
  mj_rne(model, scratch, 0, torque.data());  // 0: without accelerations
  return torque.tail<2>();
}
// #endregion

enum Way { kServos, kOffset, kEveryStep, kIntegral };

// The errors of both joints (mrad) after six seconds.
Vector2d hold(const Model& real, const Model& known, Way way) {
  const Data data = make_data(real), scratch = make_data(known);
  Vector2d sum(0, 0);
  VectorXd there = qpos(real, data);
  there.tail<2>() = kTarget;
  // #region ways
  const Vector2d once = weight(known, scratch, there);
  while (data->time < 6) {
    mj_step1(real, data);
    const Vector2d error = kTarget - qpos(real, data).tail<2>();
    Vector2d offset(0, 0);
    if (way == kOffset) offset = once.cwiseQuotient(kStiffness);
    if (way == kEveryStep)
      VectorView(data->qfrc_applied, real->nv).tail<2>() =
          weight(known, scratch, qpos(real, data));
    if (way == kIntegral) offset = sum += 1.5 * error * real->opt.timestep;
    ctrl(real, data) = kTarget + offset;
    mj_step2(real, data);
  }
  // #endregion
  const Vector2d error = 1000 * (qpos(real, data).tail<2>() - kTarget);
  return (error.array().abs() < 0.05).select(0, error);  // no "-0.0"
}

int main() {
  const Model known = load_model("arm_and_crate");
  const Model heavy = load_model("arm_and_crate");
  const int forearm = id_of(heavy, mjOBJ_BODY, "forearm");
  heavy->body_mass[forearm] *= 1.5;
  Eigen::Map<Eigen::Vector3d>(heavy->body_inertia + 3 * forearm) *= 1.5;

  std::printf("errors at rest (mrad)     as modelled      forearm +50 %%\n");
  const char* names[] = {"the servos alone", "offset, once",
                         "compensated, every step", "integral"};
  const char* keys[] = {"servos", "offset", "every_step", "integral"};
  for (const Way way : {kServos, kOffset, kEveryStep, kIntegral}) {
    const Vector2d same = hold(known, known, way);
    const Vector2d other = hold(heavy, known, way);
    std::printf("%-24s %6.1f %6.1f    %6.1f %6.1f\n", names[way], same[0] + 0.0,
                same[1] + 0.0, other[0] + 0.0, other[1] + 0.0);
    result(std::string(keys[way]) + "_same", same.cwiseAbs().maxCoeff());
    result(std::string(keys[way]) + "_heavy", other.cwiseAbs().maxCoeff());
  }
}
