// Author guide: a mistake that the compiler finds.

#include <mujoco/mujoco.h>

int size_of(const mjModel* model) {
  return model.nq;
}

int main() {}
