// Lesson 2.1: where an armature is, and where it is not.
//
// INPUT    double_pendulum.xml, both rods level, turning at 1 and -2 rad/s
// PROCESS  compute everything; give the elbow an armature of 0.1 kg m^2,
//          and compute everything again
// OUTPUT   the mass matrix, unpacked and packed; what differs, and what
//          does not
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l2_1_mass_matrix

#include <cstdio>
#include <mjcourse/mjcourse.hpp>

using namespace mjcourse;

Eigen::MatrixXd mass_matrix(const Model& model, const Data& data) {
  Eigen::MatrixXd full(model->nv, model->nv);
  mj_fullM(model, full.data(), data->qM);
  return full;  // symmetric, so rows and columns are the same
}

void compute(const Model& model, const Data& data) {
  mj_resetData(model, data);
  qvel(model, data) << 1, -2;
  mj_forward(model, data);
}

void compare(const char* what, double before, double after) {
  std::printf("%-24s %8.4f  %8.4f\n", what, before, after);
}

int main() {
  const Model model = load_model("double_pendulum");
  const Data bare = make_data(model), geared = make_data(model);
  compute(model, bare);
  const double mass = mj_getTotalmass(model);

  model->dof_armature[id_of(model, mjOBJ_JOINT, "elbow")] = 0.1;
  compute(model, geared);

  const Eigen::MatrixXd before = mass_matrix(model, bare);
  const Eigen::MatrixXd after = mass_matrix(model, geared);
  for (int row = 0; row < model->nv; ++row)
    std::printf("M %s  with armature %s\n",
                to_text(before.row(row).transpose()).c_str(),
                to_text(after.row(row).transpose()).c_str());
  std::printf("qM, as it is kept: %s\n",
              to_text(VectorView(geared->qM, model->nM)).c_str());

  const Eigen::Vector2d v(1, -2);
  std::printf("%-24s %8s  %8s\n", "", "without", "with");
  compare("qfrc_bias, elbow (N m)", bare->qfrc_bias[1], geared->qfrc_bias[1]);
  compare("potential energy (J)", bare->energy[0], geared->energy[0]);
  compare("all bodies (kg)", mass, mj_getTotalmass(model));
  compare("kinetic energy (J)", bare->energy[1], geared->energy[1]);
  compare("v M v / 2 (J)", v.dot(before * v) / 2, v.dot(after * v) / 2);
  compare("qacc, shoulder (rad/s2)", bare->qacc[0], geared->qacc[0]);
  compare("qacc, elbow (rad/s2)", bare->qacc[1], geared->qacc[1]);
}
