// Lesson 1.1: a const mjModel* does not let you change the model.

#include <mujoco/mujoco.h>

void control(const mjModel* model, mjData* data) {
  data->ctrl[0] = 0.5;
  model->opt.gravity[2] = 0;
}

int main() {
  mjcb_control = control;
}
