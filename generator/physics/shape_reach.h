// How far the shapes that MuJoCo draws reach in a direction.
#pragma once

#include <mujoco/mujoco.h>

#include <array>
#include <vector>

namespace mjcourse {

using Vector = std::array<double, 3>;

inline double dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// Of one model, whose meshes are looked through once.
class ShapeReach {
 public:
  explicit ShapeReach(const mjModel* model);

  // The greatest `way` · p of the points p of `geom`, which is one of `scene`'s and no infinite
  // plane; `way` has length 1. A mesh counts as the box around it.
  double along(const Vector& way, const mjvGeom& geom, const mjModel* model,
               const mjvScene& scene) const;

 private:
  // In the geom's own frame.
  struct Box {
    Vector least, most;
  };
  static Box box_of_mesh(const mjModel* model, int mesh);

  std::vector<Box> meshes_;
};

}  // namespace mjcourse
