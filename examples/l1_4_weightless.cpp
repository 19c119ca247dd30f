// Lesson 1.4: two ways to take an arm's weight, and what they do once it moves.
//
// INPUT    three_arms.xml, without damping
// PROCESS  hold the back arm by qfrc_applied = qfrc_bias, written anew in every
//          step; hold the middle one by xfrc_applied, its bodies' weight, written
//          once; set both in motion alike
// OUTPUT   the kinetic energy of both, and how steady their joints turn; for the
//          lesson, the energies as the table "kinetic"
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l1_4_weightless

#include <algorithm>
#include <cstdio>
#include <mjcourse/mjcourse.hpp>
#include <vector>

using namespace mjcourse;
using Eigen::Vector2d, Eigen::Matrix2d;
using RowMatrix =
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

// Of the arm whose two joints begin at `dof`: v'Mv / 2, in J.
double kinetic(const Model& model, const Data& data, int dof) {
  RowMatrix inertia(model->nv, model->nv);
  mj_fullM(model, inertia.data(), data->qM);
  const Vector2d v = qvel(model, data).segment<2>(dof);
  return 0.5 * v.dot(inertia.block<2, 2>(dof, dof) * v);
}

int main() {
  const Model model = load_model("three_arms");
  model->opt.timestep = 0.0001;
  VectorView(model->dof_damping, model->nv).setZero();
  const Data data = make_data(model);
  const Vector2d start(1, 3);  // rad/s
  qvel(model, data) << start, start, start;

  std::vector<double> time, back, middle;
  double change = 0;  // of the back arm's velocities, rad/s
  // #region loop
  for (const char* name : {"middle_upper", "middle_fore"}) {
    const int body = id_of(model, mjOBJ_BODY, name);
    data->xfrc_applied[6 * body + 2] = model->body_mass[body] * 9.81;  // once
  }
  for (int step = 0; step <= 40000; ++step) {
    mj_step1(model, data);  // all that follows from qpos and qvel
    VectorView(data->qfrc_applied, 2) = VectorView(data->qfrc_bias, 2);
    if (step % 200 == 0) {
      time.push_back(data->time);
      back.push_back(kinetic(model, data, 0));
      middle.push_back(kinetic(model, data, 2));
    }
    const Vector2d off = qvel(model, data).head<2>() - start;
    change = std::max(change, off.cwiseAbs().maxCoeff());
    mj_step2(model, data);  // forces, acceleration, and the step itself
  }
  // #endregion

  const auto report = [](const char* door, const std::vector<double>& joules) {
    const auto [least, most] =
        std::minmax_element(joules.begin(), joules.end());
    std::printf("%-28s %.3f to %.3f J\n", door, *least, *most);
    return *most / *least;
  };
  std::printf("for 4 s                      kinetic energy\n");
  result("back_ratio", report("qfrc_applied = qfrc_bias", back));
  result("middle_ratio", report("xfrc_applied, written once", middle));
  std::printf("the back arm's joints turn steadily, within 0.001 rad/s: %s\n",
              change < 0.001 ? "yes" : "no");
  table("kinetic", {{"time", time}, {"qfrc_bias", back}, {"weight", middle}});
}
