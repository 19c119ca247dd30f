#include "physics/data.h"

#include "physics/mujoco_guard.h"

namespace mjcourse {

Data::Data(const Model& model) {
  install_mujoco_guard();
  data_.reset(mj_makeData(model.get()));
}

}  // namespace mjcourse
