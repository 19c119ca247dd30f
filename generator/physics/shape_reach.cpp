#include "physics/shape_reach.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace mjcourse {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double reach_of_box(const Vector& least, const Vector& most, const Vector& way) {
  double reach = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    reach += std::max(way[axis] * least[axis], way[axis] * most[axis]);
  }
  return reach;
}

double reach_of_skin(const mjModel* model, const mjvScene& scene, int skin, const Vector& way) {
  double reach = -kInfinity;
  const float* place = scene.skinvert + std::ptrdiff_t{3} * model->skin_vertadr[skin];
  for (int i = 0; i < model->skin_vertnum[skin]; ++i, place += 3) {
    reach = std::max(reach, dot(way, {place[0], place[1], place[2]}));
  }
  return reach;
}

// Of the shapes that are made by a formula; all else is drawn as a box is here.
double reach_of_round(const mjvGeom& geom, const Vector& way) {
  const Vector size{geom.size[0], geom.size[1], geom.size[2]};
  switch (geom.type) {
    case mjGEOM_SPHERE:
      return size[0];
    case mjGEOM_CAPSULE:
      return size[0] + size[2] * std::abs(way[2]);
    case mjGEOM_CYLINDER:
      return size[0] * std::hypot(way[0], way[1]) + size[2] * std::abs(way[2]);
    case mjGEOM_ELLIPSOID:
      return std::hypot(size[0] * way[0], size[1] * way[1], size[2] * way[2]);
    case mjGEOM_PLANE:
      return reach_of_box({-size[0], -size[1], 0}, {size[0], size[1], 0}, way);
    default:
      return reach_of_box({-size[0], -size[1], -size[2]}, size, way);
  }
}

}  // namespace

ShapeReach::ShapeReach(const mjModel* model) {
  for (int mesh = 0; mesh < model->nmesh; ++mesh) meshes_.push_back(box_of_mesh(model, mesh));
}

ShapeReach::Box ShapeReach::box_of_mesh(const mjModel* model, int mesh) {
  Box box{{kInfinity, kInfinity, kInfinity}, {-kInfinity, -kInfinity, -kInfinity}};
  const float* place = model->mesh_vert + std::ptrdiff_t{3} * model->mesh_vertadr[mesh];
  for (int i = 0; i < model->mesh_vertnum[mesh]; ++i, place += 3) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      box.least[axis] = std::min(box.least[axis], double{place[axis]});
      box.most[axis] = std::max(box.most[axis], double{place[axis]});
    }
  }
  return box;
}

double ShapeReach::along(const Vector& way, const mjvGeom& geom, const mjModel* model,
                         const mjvScene& scene) const {
  if (geom.type == mjGEOM_SKIN) return reach_of_skin(model, scene, geom.objid, way);
  const double place = dot(way, {geom.pos[0], geom.pos[1], geom.pos[2]});
  Vector own;  // `way` in the geom's frame
  for (std::size_t axis = 0; axis < 3; ++axis) {
    own[axis] = dot(way, {geom.mat[axis], geom.mat[3 + axis], geom.mat[6 + axis]});
  }
  if (geom.type == mjGEOM_MESH) {
    const Box& box = meshes_[static_cast<std::size_t>(geom.dataid / 2)];
    return place + reach_of_box(box.least, box.most, own);
  }
  if (geom.type == mjGEOM_HFIELD) {
    const mjtNum* size = model->hfield_size + std::ptrdiff_t{4} * geom.dataid;
    return place + reach_of_box({-size[0], -size[1], -size[3]}, {size[0], size[1], size[2]}, own);
  }
  return place + reach_of_round(geom, own);
}

}  // namespace mjcourse
