// Author guide: a program that shows what programs can tell their lesson.
//
// INPUT    guide_pendulum.xml
// PROCESS  let the pendulum go at 90 degrees; follow its energy for a second
// OUTPUT   the angle at the end, and how much energy the damping took

#include <cstdio>
#include <mjcourse/mjcourse.hpp>
#include <vector>

using namespace mjcourse;

// #region energy
double energy(const Model& model, const Data& data) {
  mj_energyPos(model, data);
  mj_energyVel(model, data);
  return data->energy[0] + data->energy[1];
}
// #endregion

int main() {
  const Model model = load_model("guide_pendulum");
  const Data data = make_data(model);
  qpos(model, data)[0] = M_PI / 2;
  mj_forward(model, data);

  std::vector<double> times, energies;
  while (data->time < 1) {
    times.push_back(data->time);
    energies.push_back(energy(model, data));
    mj_step(model, data);
  }
  mj_forward(model, data);
  const double lost = energies.front() - energy(model, data);

  // #region report
  print("angle after 1 s (rad):", qpos(model, data)[0]);
  print("energy lost (J):", lost);

  result("lost", lost);
  table("energy", {{"time", times}, {"energy", energies}});
  snapshot("end", model, data);
  // #endregion
}
