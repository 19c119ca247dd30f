// Lesson 2.1: "Nan, Inf or huge value in QACC", and what comes after it.
//
// INPUT    screwdriver.xml, the servo of its tool without a limit
// PROCESS  ask the tool to turn by 0.5 rad; simulate 1000 steps of 2 ms; then
//          again, with the armature that the rotor of its motor has
// OUTPUT   the tool's way out; MuJoCo's message; how often it reset the
//          simulation, and how often it says so
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l2_1_unstable

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <mjcourse/mjcourse.hpp>
#include <string>

using namespace mjcourse;

static int messages;

// #region run
struct Run {
  int resets = 0;
  double farthest = 0;  // rad, of the tool
  double growth = 0;    // of its angle, in step 10
};

Run simulate(const Model& model, const Data& data, bool tell) {
  Run run;
  for (int step = 1; step <= 1000; ++step) {
    const double before = data->time, angle = data->qpos[1];
    ctrl(model, data) << 0, 0.5;  // each time, for a reset clears it
    mj_step(model, data);
    const bool reset = data->time <= before;
    run.resets += reset;
    if (step == 10) run.growth = data->qpos[1] / angle;
    run.farthest = std::max(run.farthest, std::abs(data->qpos[1]));
    if (tell && (step <= 4 || (step >= 9 && step <= 12)))
      std::printf("%4d %10.3f %12.4g %13.3g%s\n", step, data->time,
                  data->qpos[1], data->qacc[1], reset ? "  reset" : "");
  }
  return run;
}
// #endregion

int main() {
  mju_user_warning = [](const char* message) {
    std::string text = message;
    text.replace(text.find(" The"), 1, "\n        ");  // a line is too short
    std::printf("MuJoCo: %s\n", text.c_str());
    ++messages;
  };
  const Model model = load_model("screwdriver");
  model->opt.timestep = 0.002;  // MuJoCo's default
  const int servo = id_of(model, mjOBJ_ACTUATOR, "tool");
  model->actuator_forcelimited[servo] = 0;

  std::printf("step   time (s)   tool (rad)  qacc (rad/s2)\n");
  const Data data = make_data(model);
  const Run bare = simulate(model, data, true);
  const mjWarningStat& warning = data->warning[mjWARN_BADQACC];
  const int joint = model->dof_jntid[warning.lastinfo];
  std::printf("DOF %d is the joint '%s'\n", warning.lastinfo,
              mj_id2name(model, mjOBJ_JOINT, joint));
  std::printf("resets: %d, messages: %d, counted: %d, clock: %.3f s\n",
              bare.resets, messages, warning.number, data->time);
  result("step_ms", 1000 * model->opt.timestep);
  result("growth", -bare.growth);
  result("resets", bare.resets);
  result("messages", messages);
  result("counted", warning.number);
  result("clock", data->time);

  // And with a control that is written once.
  mju_user_warning = [](const char*) {};
  const Data once = make_data(model);
  once->ctrl[1] = 0.5;
  for (int step = 0; step < 500; ++step) mj_step(model, once);
  result("once", once->time);

  // A rotor of 20 g and 10 mm radius, behind a gear of 50.
  const double rotor = 0.5 * 0.02 * 0.01 * 0.01, gear = 50;
  model->dof_armature[joint] = gear * gear * rotor;
  const Data again = make_data(model);
  const Run cured = simulate(model, again, false);
  std::printf("with an armature of %.4f kg m^2\n", model->dof_armature[joint]);
  std::printf("resets: %d, farthest: %.3f rad, clock: %.3f s\n", cured.resets,
              cured.farthest, again->time);
  result("armature", model->dof_armature[joint]);
  result("times_tool", model->dof_armature[joint] / 1e-4);
}
