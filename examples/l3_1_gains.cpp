// Lesson 3.1, exercise: make a servo of a motor.
//
// INPUT    servo_arm.xml, its servo off, its motor with a gear, a load, an
//          armature and a joint damping of several sizes
// PROCESS  work out what has to stand in gainprm and biasprm; simulate
// OUTPUT   the gains of the first case; checks where the arm rests, how its
//          angle follows the control, overshoot and time
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l3_1_gains

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <mjcourse/mjcourse.hpp>

using namespace mjcourse;

// Makes the motor a position servo whose ctrl is the wanted angle of the joint.
// The level arm is to hang by `sag` (rad) below it, and to be critically
// damped. `level` holds the arm there, after mj_forward: with one joint, qM and
// qfrc_bias are one number each.
void make_servo(const Model& model, const Data& level, int motor, double sag) {
  const double gear = model->actuator_gear[6 * motor];
  mjtNum* gain = model->actuator_gainprm + mjNGAIN * motor;
  mjtNum* bias = model->actuator_biasprm + mjNBIAS * motor;
  // #region answer
  const double stiffness = level->qfrc_bias[0] / sag;  // at the joint
  const double needed = 2 * std::sqrt(stiffness * level->qM[0]);
  model->actuator_biastype[motor] = mjBIAS_AFFINE;
  gain[0] = stiffness / gear;
  bias[1] = -stiffness / (gear * gear);
  bias[2] = -(needed - model->dof_damping[0]) / (gear * gear);
  // #starter
  // model->actuator_biastype[motor] = mjBIAS_AFFINE;
  // gain[0] = 1 / gear;  // how stiff must it be?
  // bias[1] = -1 / (gear * gear);
  // bias[2] = 0;
  // #wrong stays-a-motor: the arm rests level
  // const double stiffness = level->qfrc_bias[0] / sag;
  // const double needed = 2 * std::sqrt(stiffness * level->qM[0]);
  // gain[0] = stiffness / gear;
  // bias[1] = -stiffness / (gear * gear);
  // bias[2] = -(needed - model->dof_damping[0]) / (gear * gear);
  // #wrong forgets-the-gear: the arm rests level
  // const double stiffness = level->qfrc_bias[0] / sag;
  // const double needed = 2 * std::sqrt(stiffness * level->qM[0]);
  // model->actuator_biastype[motor] = mjBIAS_AFFINE;
  // gain[0] = stiffness;
  // bias[1] = -stiffness;
  // bias[2] = -(needed - model->dof_damping[0]);
  // #wrong takes-the-gear-once: without gravity, the angle
  // const double stiffness = level->qfrc_bias[0] / sag;
  // const double needed = 2 * std::sqrt(stiffness * level->qM[0]);
  // model->actuator_biastype[motor] = mjBIAS_AFFINE;
  // gain[0] = stiffness / gear;
  // bias[1] = -stiffness / gear;
  // bias[2] = -(needed - model->dof_damping[0]) / gear;
  // #wrong damps-by-half: the arm does not overshoot
  // const double stiffness = level->qfrc_bias[0] / sag;
  // const double half = std::sqrt(stiffness * level->qM[0]);
  // model->actuator_biastype[motor] = mjBIAS_AFFINE;
  // gain[0] = stiffness / gear;
  // bias[1] = -stiffness / (gear * gear);
  // bias[2] = -(half - model->dof_damping[0]) / (gear * gear);
  // #wrong forgets-the-armature: the arm does not overshoot
  // const double stiffness = level->qfrc_bias[0] / sag;
  // const double bare = level->qM[0] - model->dof_armature[0];
  // const double needed = 2 * std::sqrt(stiffness * bare);
  // model->actuator_biastype[motor] = mjBIAS_AFFINE;
  // gain[0] = stiffness / gear;
  // bias[1] = -stiffness / (gear * gear);
  // bias[2] = -(needed - model->dof_damping[0]) / (gear * gear);
  // #wrong forgets-the-joint-damping: the arm is there in time
  // const double stiffness = level->qfrc_bias[0] / sag;
  // const double needed = 2 * std::sqrt(stiffness * level->qM[0]);
  // model->actuator_biastype[motor] = mjBIAS_AFFINE;
  // gain[0] = stiffness / gear;
  // bias[1] = -stiffness / (gear * gear);
  // bias[2] = -needed / (gear * gear);
  // #endregion
}

struct Case {
  double sag, gear, load, armature, damping;
};

// The arm, whose motor has become the servo.
Model arm(const Case& c) {
  const Model model = load_model("servo_arm");
  const int off = id_of(model, mjOBJ_ACTUATOR, "servo");
  const int motor = id_of(model, mjOBJ_ACTUATOR, "motor");
  model->actuator_gainprm[mjNGAIN * off] = 0;
  model->actuator_biasprm[mjNBIAS * off + 1] = 0;
  model->actuator_gear[6 * motor] = c.gear;
  model->body_mass[id_of(model, mjOBJ_BODY, "load")] = c.load;
  model->dof_armature[0] = c.armature;
  model->dof_damping[0] = c.damping;
  model->opt.timestep = 0.0005;
  const Data level = make_data(model);
  mj_forward(model, level);
  make_servo(model, level, motor, c.sag);
  return Model(mj_copyModel(nullptr, model));
}

struct Run {
  double angle, most, settled;  // at the end, at most (rad); within 1 % (s)
};
Run run(const Model& model, double from, double wanted) {
  const Data data = make_data(model);
  data->qpos[0] = from;
  data->ctrl[1] = wanted;
  Run found{from, from, 0};
  for (int step = 1; step <= 6000; ++step) {
    mj_step(model, data);
    found.angle = data->qpos[0];
    found.most = std::max(found.most, found.angle);
    if (std::abs(found.angle - wanted) > 0.01 * wanted)
      found.settled = step * model->opt.timestep;
    if (data->warning[mjWARN_BADQACC].number > 0) found.angle = HUGE_VAL;
    if (std::isinf(found.angle)) break;  // MuJoCo has begun anew
  }
  return found;
}

void check(const Case& c) {
  const Model model = arm(c);
  const Data level = make_data(model);
  mj_forward(model, level);
  const double fast = std::sqrt(level->qfrc_bias[0] / c.sag / level->qM[0]);
  if (!expect_near(run(model, -0.3, c.sag).angle, 0, 1e-4,
                   "the arm rests level if ctrl is the sag",
                   "it needs a bias that depends on the angle, and a stiffness "
                   "at the joint of weight over sag; a gear acts on the length "
                   "and on the force"))
    return;
  model->opt.gravity[2] = 0;
  const Run step = run(model, 0, 0.5);
  if (!expect_near(step.angle, 0.5, 1e-4,
                   "without gravity, the angle is what ctrl says",
                   "the servo compares ctrl with the actuator's length, which "
                   "is gear times angle"))
    return;
  if (expect(step.most < 0.5005, "the arm does not overshoot",
             "critical damping is 2 sqrt(k I), with all of the inertia"))
    expect(step.settled < 7.2 / fast, "the arm is there in time",
           "more damping than critical creeps; the joint has some already");
}

int main() {
  const Case first{0.02, 20, 0.5, 0.1, 5};
  const Model model = arm(first);
  std::printf("gear %.0f: gainprm %.3f, biasprm 0 %.4f %.4f\n", first.gear,
              model->actuator_gainprm[mjNGAIN],
              model->actuator_biasprm[mjNBIAS + 1],
              model->actuator_biasprm[mjNBIAS + 2]);
  for (const Case& c :
       {first, Case{0.05, 1, 0, 0.02, 3}, Case{0.01, 50, 1, 0.2, 8}})
    check(c);
}
