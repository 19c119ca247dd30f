// An mjData that deletes itself.
// Tested by tests/generator/physics/field_table_test.cpp.
#pragma once

#include <mujoco/mujoco.h>

#include <memory>

#include "physics/model.h"

namespace mjcourse {

class Data {
 public:
  // The initial state of `model`, nothing computed yet. Throws MujocoError when there is no memory
  // for it.
  explicit Data(const Model& model);

  mjData* get() { return data_.get(); }
  const mjData* get() const { return data_.get(); }
  mjData* operator->() { return data_.get(); }
  const mjData* operator->() const { return data_.get(); }

 private:
  struct Delete {
    void operator()(mjData* data) const { mj_deleteData(data); }
  };
  std::unique_ptr<mjData, Delete> data_;
};

}  // namespace mjcourse
