// Lesson 1.1: the model is told of a new mass, in mid-swing.
//
// INPUT    arm_and_crate.xml, its arm on the way to the targets 1.4 and 1.8 rad
// PROCESS  double the crate's mass after 0.5 s and call mj_setConst: (1) on the
//          data of the simulation; (2) there again, with a springref of 0.4 rad
//          in the elbow; (3) on data of its own
// OUTPUT   the elbow's angle before the call and after it, and its speed after it
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l1_1_set_const

#include <cstdio>
#include <mjcourse/mjcourse.hpp>

using namespace mjcourse;

// #region call
void on_data_of_the_simulation(mjModel* model, mjData* data) {
  model->body_mass[id_of(model, mjOBJ_BODY, "crate")] *= 2;
  mj_setConst(model, data);  // and qpos is gone
}

void on_data_of_its_own(mjModel* model, mjData*) {
  model->body_mass[id_of(model, mjOBJ_BODY, "crate")] *= 2;
  const Data scratch = make_data(model);
  mj_setConst(model, scratch);
}
// #endregion

void try_out(const char* name, void (*tell)(mjModel*, mjData*),
             double springref) {
  const Model model = load_model("arm_and_crate");
  const Data data = make_data(model);
  const int elbow = id_of(model, mjOBJ_JOINT, "elbow");
  const int qadr = model->jnt_qposadr[elbow];
  ctrl(model, data) << 1.4, 1.8;
  for (int step = 0; step < 250; ++step) mj_step(model, data);

  model->qpos_spring[qadr] = springref;  // the joint has no spring: no force
  const double before = data->qpos[qadr];
  tell(model, data);
  std::printf("%-18s  elbow  %.3f -> %.3f rad, at %.2f rad/s\n", name, before,
              data->qpos[qadr], data->qvel[model->jnt_dofadr[elbow]]);
}

int main() {
  try_out("simulation's data", on_data_of_the_simulation, 0);
  try_out("with a springref", on_data_of_the_simulation, 0.4);
  try_out("data of its own", on_data_of_its_own, 0);
}
