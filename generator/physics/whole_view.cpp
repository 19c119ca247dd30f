#include "physics/whole_view.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace mjcourse {
namespace {

// A camera at 1.5 extents sees so much of an extent to each side of the center.
constexpr double kSeen = 0.6;
constexpr double kFarthest = 3;  // extents

class SkinScene {
 public:
  explicit SkinScene(const mjModel* model) {
    mjv_defaultScene(&scene_);
    mjv_makeScene(model, &scene_, 0);
  }
  ~SkinScene() { mjv_freeScene(&scene_); }
  SkinScene(const SkinScene&) = delete;
  SkinScene& operator=(const SkinScene&) = delete;

  mjvScene* get() { return &scene_; }

 private:
  mjvScene scene_;
};

double distance(const double* a, const std::array<double, 3>& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

}  // namespace

WholeView::WholeView(const Model& model)
    : stat_center_{model->stat.center[0], model->stat.center[1], model->stat.center[2]},
      stat_extent_(model->stat.extent),
      geoms_(static_cast<std::size_t>(model->ngeom), Trail{stat_center_, stat_center_}),
      skins_(static_cast<std::size_t>(model->nskin), Trail{stat_center_, stat_center_}) {}

void WholeView::add_ball(Trail& trail, const double* center, double radius) const {
  trail.reach = std::max(trail.reach, distance(center, stat_center_) + radius);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    trail.least[axis] = std::min(trail.least[axis], center[axis] - radius);
    trail.most[axis] = std::max(trail.most[axis], center[axis] + radius);
  }
}

void WholeView::add(const Simulation& simulation) {
  const mjModel* model = simulation.model().get();
  for (int geom = 0; geom < model->ngeom; ++geom) {
    const bool moves = model->body_weldid[model->geom_bodyid[geom]] != 0;
    if (!moves || model->geom_rbound[geom] <= 0) continue;
    add_ball(geoms_[static_cast<std::size_t>(geom)],
             simulation.data()->geom_xpos + std::ptrdiff_t{3} * geom, model->geom_rbound[geom]);
  }
  if (model->nskin > 0) add_skins(simulation);
}

void WholeView::add_skins(const Simulation& simulation) {
  const mjModel* model = simulation.model().get();
  auto* data = const_cast<mjData*>(simulation.data().get());  // which MuJoCo only reads
  SkinScene scene(model);
  mjvOption options;
  mjv_defaultOption(&options);
  mjvCamera camera;
  mjv_defaultCamera(&camera);
  const int no_geoms = 0;
  mjv_updateScene(model, data, &options, nullptr, &camera, no_geoms, scene.get());
  for (int skin = 0; skin < model->nskin; ++skin) {
    if (options.skingroup[model->skin_group[skin]] == 0) continue;
    const float* place = scene.get()->skinvert + std::ptrdiff_t{3} * model->skin_vertadr[skin];
    for (int i = 0; i < model->skin_vertnum[skin]; ++i, place += 3) {
      const std::array<double, 3> corner{place[0], place[1], place[2]};
      add_ball(skins_[static_cast<std::size_t>(skin)], corner.data(), 0);
    }
  }
}

WholeView::Trail WholeView::all() const {
  Trail all{stat_center_, stat_center_};
  for (const auto* trails : {&geoms_, &skins_}) {
    for (const Trail& trail : *trails) {
      if (!(trail.reach <= kFarthest * stat_extent_)) continue;
      all.reach = std::max(all.reach, trail.reach);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        all.least[axis] = std::min(all.least[axis], trail.least[axis]);
        all.most[axis] = std::max(all.most[axis], trail.most[axis]);
      }
    }
  }
  return all.reach <= kSeen * stat_extent_ ? Trail{stat_center_, stat_center_} : all;
}

std::array<double, 3> WholeView::center() const {
  const Trail seen = all();
  std::array<double, 3> center{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    center[axis] = (seen.least[axis] + seen.most[axis]) / 2;
  }
  return center;
}

double WholeView::extent() const {
  const Trail seen = all();
  return std::max(stat_extent_, distance(seen.most.data(), seen.least) / 2 / kSeen);
}

}  // namespace mjcourse
