#include "physics/data.h"

#include <cstddef>
#include <limits>

#include "physics/mujoco_guard.h"

namespace mjcourse {

Data::Data(const Model& model) {
  install_mujoco_guard();
  // NULL where a size is beyond what an address can say; MuJoCo looks at all but the stack's.
  constexpr std::size_t most = std::numeric_limits<std::ptrdiff_t>::max() / sizeof(mjtNum);
  if (static_cast<std::size_t>(model.get()->nstack) <= most) data_.reset(mj_makeData(model.get()));
  if (!data_) throw MujocoError("could not create mjData: the model asks for too much memory");
}

}  // namespace mjcourse
