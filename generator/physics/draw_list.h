// MuJoCo's list of the shapes that make a picture, with room for all of them.
//
// MuJoCo leaves out what does not fit into its list. How much there is depends on the overlays and
// on the state as well as on the model, so the list grows when it is full. In the page it is the
// same one.
// Tested by tests/generator/physics/shape_reach_test.cpp.
#pragma once

#include <mujoco/mujoco.h>

namespace mjcourse {

// In one picture, frames' axes and the like counted: a list of 40 MB.
inline constexpr int kMostShapes = 160000;

class DrawList {
 public:
  // Empty, without a model.
  DrawList();
  ~DrawList();
  DrawList(const DrawList&) = delete;
  DrawList& operator=(const DrawList&) = delete;

  // For pictures of `model`. Throws a MujocoError where there is no memory for it.
  void make(const mjModel* model);
  // mjv_updateScene. False where there are more than kMostShapes: the rest is left out.
  bool update(const mjModel* model, mjData* data, const mjvOption& options,
              const mjvPerturb* perturb, mjvCamera& camera);
  // Gives its memory back.
  void clear();

  mjvScene& scene() { return scene_; }
  const mjvScene& scene() const { return scene_; }

 private:
  void widen();

  mjvScene scene_;
};

}  // namespace mjcourse
