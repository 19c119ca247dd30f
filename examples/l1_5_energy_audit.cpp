// Lesson 1.5: an energy audit. A pendulum without friction must keep its energy.
//
// INPUT    double_pendulum.xml, let go level and at rest: 0 J
// PROCESS  simulate two seconds with three settings; read MuJoCo's energy, and
//          compare the kinetic part with (1/2) v'Mv
// OUTPUT   the account of the coarsest setting; for the lesson, all three totals
//          as the table "trace"
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l1_5_energy_audit

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <mjcourse/mjcourse.hpp>
#include <vector>

using namespace mjcourse;
using Eigen::VectorXd;
using RowMatrix =
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

// The same by hand: MuJoCo keeps M sparse, and mj_fullM unpacks it.
double kinetic_by_hand(const Model& model, const Data& data) {
  RowMatrix inertia(model->nv, model->nv);
  mj_fullM(model, inertia.data(), data->qM);
  const VectorXd v = qvel(model, data);
  return 0.5 * v.dot(inertia * v);
}

struct Run {
  std::vector<double> time, total;  // every 20 ms
  VectorXd qpos;                    // at the end
  double fastest = 0;               // the largest kinetic energy, J
  double disagreement = 0;          // of the two kinetic energies, J
};

Run audit(const Model& model, int integrator, double timestep, bool show) {
  model->opt.integrator = integrator;
  model->opt.timestep = timestep;
  const Data data = make_data(model);
  const int every = std::lround(0.02 / timestep), steps = 100 * every;

  Run run;
  for (int step = 0; step <= steps; ++step) {
    if (step > 0) mj_step(model, data);
    mj_forward(model, data);  // all of data at one instant, energy included
    const double potential = data->energy[0], kinetic = data->energy[1];
    const double difference = kinetic - kinetic_by_hand(model, data);
    run.disagreement = std::max(run.disagreement, std::abs(difference));
    run.fastest = std::max(run.fastest, kinetic);
    if (step % every == 0) {
      run.time.push_back(data->time);
      run.total.push_back(potential + kinetic);
    }
    if (show && step % (steps / 4) == 0)
      std::printf("%6.1f  %10.4f  %8.4f  %7.4f\n", data->time, potential,
                  kinetic, potential + kinetic);
  }
  run.qpos = qpos(model, data);
  return run;
}

int main() {
  const Model model = load_model("double_pendulum");
  std::printf("t (s)  potential   kinetic  total (J)\n");
  const Run coarse = audit(model, mjINT_EULER, 0.01, true);
  const Run fine = audit(model, mjINT_EULER, 0.002, false);
  const Run rk4 = audit(model, mjINT_RK4, 0.01, false);
  std::printf("kinetic agrees with v'Mv / 2 to 1e-12 J: %s\n",
              coarse.disagreement < 1e-12 ? "yes" : "no");

  result("coarse", coarse.total.back());  // J
  result("fine", fine.total.back());
  result("rk4_uJ", 1e6 * std::abs(rk4.total.back()));
  result("fastest", rk4.fastest);
  result("share", 100 * coarse.total.back() / rk4.fastest);  // %
  result("angle_apart", (coarse.qpos - rk4.qpos).cwiseAbs().maxCoeff());
  table("trace", {{"time", coarse.time},
                  {"Euler, 10 ms", coarse.total},
                  {"Euler, 2 ms", fine.total},
                  {"RK4, 10 ms", rk4.total}});
}
