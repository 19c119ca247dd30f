#include "scene.h"

#include <algorithm>
#include <exception>
#include <string_view>

#include "allocation_scope.h"
#include "physics/data.h"
#include "physics/draw_list.h"
#include "physics/mujoco_guard.h"
#include "physics/overlay_table.h"
#include "simulation_handle.h"

struct mjcScene_ {
  explicit mjcScene_(mjcSimulation& shown) : simulation(shown), stand_in(shown.model()) {
    mjv_defaultOption(&options);
    mjv_defaultCamera(&camera);
    mjv_defaultPerturb(&perturb);
    shapes.make(model());
  }
  mjcScene_(const mjcScene_&) = delete;
  mjcScene_& operator=(const mjcScene_&) = delete;

  mjModel* model() { return simulation.model().get(); }
  mjData* data() { return simulation.data().get(); }

  mjcSimulation& simulation;
  mjcourse::Data stand_in;  // takes the place of the simulation's data
  mjvOption options;
  mjvCamera camera;
  mjvPerturb perturb;
  mjcourse::DrawList shapes;
  int pulled = 0;  // the body whose xfrc_applied is ours
};

mjcScene* mjc_scene_new(mjcSimulation* simulation) {
  AllocationScope scope;
  try {
    auto* scene = new mjcScene(*simulation);
    scope.keep();
    return scene;
  } catch (const std::exception&) {
    return nullptr;
  }
}

void mjc_scene_free(mjcScene* scene) {
  delete scene;
}

int mjc_scene_overlay(mjcScene* scene, const char* name, int on) {
  int count = 0;
  const mjcOverlay* first = mjc_overlays(&count);
  const mjcOverlay* found = std::find_if(first, first + count, [name](const mjcOverlay& o) {
    return std::string_view(o.name) == name;
  });
  if (found == first + count) return 0;
  mjc_set_overlay(&scene->options, found, on);
  return 1;
}

const char* mjc_overlay_name(int index) {
  int count = 0;
  const mjcOverlay* overlays = mjc_overlays(&count);
  return index < count ? overlays[index].name : nullptr;
}

int mjc_scene_shows_overlay(const mjcScene* scene, int index) {
  int count = 0;
  const mjcOverlay* overlays = mjc_overlays(&count);
  return index < count ? mjc_shows_overlay(&scene->options, overlays + index) : 0;
}

// mj_forward brings what is drawn up to date with the state. On the simulation's own data it would
// also change the solver's warm start, and with it the last bits of every later step.
int mjc_scene_update(mjcScene* scene) {
  if (scene->simulation.stopped()) return 0;
  const mjcourse::WarningLog log;
  const mjModel* model = scene->model();
  mjData* data = scene->stand_in.get();
  try {
    mj_copyData(data, model, scene->data());
    mj_forward(model, data);
    scene->shapes.update(model, data, scene->options, &scene->perturb, scene->camera);
  } catch (const mjcourse::MujocoError&) {
    return 0;
  }
  return 1;
}

const mjvGeom* mjc_scene_geoms(const mjcScene* scene) {
  return scene->shapes.scene().geoms;
}

int mjc_scene_geom_count(const mjcScene* scene) {
  return scene->shapes.scene().ngeom;
}

const float* mjc_scene_skin_vertices(const mjcScene* scene) {
  return scene->shapes.scene().skinvert;
}

const float* mjc_scene_skin_normals(const mjcScene* scene) {
  return scene->shapes.scene().skinnormal;
}

int mjc_scene_skin_vertex_count(const mjcScene* scene) {
  return scene->simulation.model()->nskinvert;
}

const mjvLight* mjc_scene_lights(const mjcScene* scene) {
  return scene->shapes.scene().lights;
}

int mjc_scene_light_count(const mjcScene* scene) {
  return scene->shapes.scene().nlight;
}

const mjvGLCamera* mjc_scene_view(const mjcScene* scene) {
  return scene->shapes.scene().camera;
}

mjvCamera* mjc_scene_camera(mjcScene* scene) {
  return &scene->camera;
}

void mjc_scene_move_camera(mjcScene* scene, int action, double dx, double dy) {
  mjv_moveCamera(scene->model(), action, dx, dy, &scene->shapes.scene(), &scene->camera);
}

int mjc_scene_select(mjcScene* scene, double aspect, double x, double y) {
  mjtNum point[3];
  int geom = -1;
  int skin = -1;
  const mjData* data = scene->stand_in.get();
  const int body = mjv_select(scene->model(), data, &scene->options, aspect, x, y,
                              &scene->shapes.scene(), point, &geom, &skin);
  mjvPerturb& perturb = scene->perturb;
  perturb.select = std::max(body, 0);
  perturb.active = 0;
  if (perturb.select == 0) return 0;
  mjtNum from_body[3];
  mju_sub3(from_body, point, data->xpos + 3 * body);
  mju_rotVecMatT(perturb.localpos, from_body, data->xmat + 9 * body);
  return body;
}

void mjc_scene_grab(mjcScene* scene, int kind) {
  mjvPerturb& perturb = scene->perturb;
  if (kind != 0 && perturb.active == 0) {
    mjv_initPerturb(scene->model(), scene->stand_in.get(), &scene->shapes.scene(), &perturb);
  }
  perturb.active = perturb.select > 0 ? kind : 0;
}

void mjc_scene_drag(mjcScene* scene, int action, double dx, double dy) {
  mjv_movePerturb(scene->model(), scene->stand_in.get(), action, dx, dy, &scene->shapes.scene(),
                  &scene->perturb);
}

void mjc_scene_pull(mjcScene* scene) {
  mjData* data = scene->data();
  if (scene->pulled > 0) mju_zero(data->xfrc_applied + 6 * scene->pulled, 6);
  scene->pulled = scene->perturb.active != 0 ? scene->perturb.select : 0;
  mjv_applyPerturbPose(scene->model(), data, &scene->perturb, 0);
  mjv_applyPerturbForce(scene->model(), data, &scene->perturb);
}
