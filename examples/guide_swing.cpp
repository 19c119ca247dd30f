// Author guide: a program that shows what programs can tell their lesson.
//
// INPUT    guide_pendulum.xml
// PROCESS  let the pendulum go at 90 degrees; follow it for a second
// OUTPUT   the angle at the end, and how much energy the damping took; for the
//          lesson, the way there as the table "swing" and its end as a snapshot

#include <mjcourse/mjcourse.hpp>
#include <vector>

using namespace mjcourse;

// #region energy
struct Energy {
  double potential, kinetic;  // J
};

Energy energy(const Model& model, const Data& data) {
  mj_forward(model, data);  // the model's flag asks it for the energy, too
  return {data->energy[0], data->energy[1]};
}
// #endregion

int main() {
  const Model model = load_model("guide_pendulum");
  const Data data = make_data(model);
  qpos(model, data)[0] = M_PI / 2;
  const double before = energy(model, data).potential;

  // #region follow
  std::vector<double> time, angle, speed, potential, kinetic;
  for (int step = 0; step <= 500; ++step) {
    if (step > 0) mj_step(model, data);
    if (step % 10 > 0) continue;
    const Energy now = energy(model, data);
    time.push_back(data->time);
    angle.push_back(qpos(model, data)[0]);
    speed.push_back(qvel(model, data)[0]);
    potential.push_back(now.potential);
    kinetic.push_back(now.kinetic);
  }
  // #endregion
  const double lost = before - potential.back() - kinetic.back();

  // #region report
  print("angle after 1 s (rad):", angle.back());
  print("energy lost (J):", lost);

  result("lost", lost);
  table("swing", {{"time", time},
                  {"angle", angle},
                  {"speed", speed},
                  {"potential", potential},
                  {"kinetic", kinetic}});
  snapshot("end", model, data);
  // #endregion
}
