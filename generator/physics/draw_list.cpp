#include "physics/draw_list.h"

#include "physics/mujoco_guard.h"

namespace mjcourse {
namespace {

constexpr int kAtFirst = 10000;

}  // namespace

DrawList::DrawList() {
  mjv_defaultScene(&scene_);
}

DrawList::~DrawList() {
  clear();
}

void DrawList::make(const mjModel* model) {
  mjv_makeScene(model, &scene_, kAtFirst);
}

bool DrawList::update(const mjModel* model, mjData* data, const mjvOption& options,
                      const mjvPerturb* perturb, mjvCamera& camera) {
  const mjWarningStat counted = data->warning[mjWARN_VGEOMFULL];
  for (;;) {
    const WarningLog full;  // which says no more than is seen below
    mjv_updateScene(model, data, &options, perturb, &camera, mjCAT_ALL, &scene_);
    if (scene_.ngeom < scene_.maxgeom) return true;
    data->warning[mjWARN_VGEOMFULL] = counted;  // a simulation counts its own warnings
    if (scene_.maxgeom > kMostShapes) return false;
    widen();
  }
}

void DrawList::clear() {
  mjv_freeScene(&scene_);
}

// What it lists is lost, and everything else is kept. MuJoCo skips nothing as long as one place is
// left over.
void DrawList::widen() {
  const int wider = scene_.maxgeom < kMostShapes / 2 ? 2 * scene_.maxgeom : kMostShapes + 1;
  mju_free(scene_.geoms);
  mju_free(scene_.geomorder);
  scene_.geoms = nullptr;
  scene_.geomorder = nullptr;
  scene_.maxgeom = scene_.ngeom = 0;
  scene_.geoms = static_cast<mjvGeom*>(mju_malloc(static_cast<size_t>(wider) * sizeof(mjvGeom)));
  scene_.geomorder = static_cast<int*>(mju_malloc(static_cast<size_t>(wider) * sizeof(int)));
  scene_.maxgeom = wider;
}

}  // namespace mjcourse
