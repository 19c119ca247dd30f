#include <cstdio>
#include <mjcourse/mjcourse.hpp>

using namespace mjcourse;

int main() {
  const Model model = load_model("arm");
  const Data now = make_data(model);
  // #region motor
  now->ctrl[0] = model->actuator_ctrlrange[1];
  while (now->time < 1) mj_step(model, now);
  // #endregion
  std::printf("%d numbers, %g s a step\n", model->nq, model->opt.timestep);
}
