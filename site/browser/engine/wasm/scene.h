/* What a page draws: MuJoCo's own scene of a simulation, and the mouse in it.
 *
 * mjc_scene_update makes the list of mjvGeom, the lights and the camera that MuJoCo's renderer
 * would draw; the page reads them where they lie (struct_layout.h). A picture drawn by the
 * generator and the live view come from the same calls in the same order
 * (generator/physics/renderer.cpp), so they show the same things. */
#ifndef MJCOURSE_ENGINE_SCENE_H_
#define MJCOURSE_ENGINE_SCENE_H_

#include "engine.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct mjcScene_ mjcScene;

/* A scene that is seen by a free camera at MuJoCo's defaults. NULL when MuJoCo has no memory for
 * it. Free it before the simulation. */
MJC_EXPORT mjcScene* mjc_scene_new(mjcSimulation* simulation);
MJC_EXPORT void mjc_scene_free(mjcScene* scene);

/* Switch an overlay (physics/overlay_table.h) on or off; returns 0 when there is none of that name.
 */
MJC_EXPORT int mjc_scene_overlay(mjcScene* scene, const char* name, int on);
/* The name of overlay `index`; NULL past the last. */
MJC_EXPORT const char* mjc_overlay_name(int index);
/* Is overlay `index` on? */
MJC_EXPORT int mjc_scene_shows_overlay(const mjcScene* scene, int index);

/* Bring the scene up to date with the simulation, whose data are not touched. Returns 0, and leaves
 * the scene as it was, when the simulation has stopped. */
MJC_EXPORT int mjc_scene_update(mjcScene* scene);

/* After an update: MuJoCo's structs. */
MJC_EXPORT const mjvGeom* mjc_scene_geoms(const mjcScene* scene);
MJC_EXPORT int mjc_scene_geom_count(const mjcScene* scene);
MJC_EXPORT const mjvLight* mjc_scene_lights(const mjcScene* scene);
MJC_EXPORT int mjc_scene_light_count(const mjcScene* scene);
MJC_EXPORT const mjvGLCamera* mjc_scene_view(const mjcScene* scene);
/* The skins' vertices and their normals, three numbers each, in the world's frame; the vertices of
 * one lie where mjModel's skin_vertadr says. */
MJC_EXPORT const float* mjc_scene_skin_vertices(const mjcScene* scene);
MJC_EXPORT const float* mjc_scene_skin_normals(const mjcScene* scene);
MJC_EXPORT int mjc_scene_skin_vertex_count(const mjcScene* scene);
/* The camera is the page's to set. */
MJC_EXPORT mjvCamera* mjc_scene_camera(mjcScene* scene);

/* Move the camera by a part (dx, dy) of the window's height, as the mouse action (mjtMouse) says.
 */
MJC_EXPORT void mjc_scene_move_camera(mjcScene* scene, int action, double dx, double dy);

/* The mouse. (x, y) is a place in the window, 0 to 1 from its lower left; `aspect` is its width
 * over its height. */

/* Select the body that is seen there, and the point on it, for the pulls that follow. Returns the
 * body; 0 when there is none, and nothing is selected. */
MJC_EXPORT int mjc_scene_select(mjcScene* scene, double aspect, double x, double y);

/* Begin to pull (mjPERT_TRANSLATE), to turn (mjPERT_ROTATE), or, with 0, let go. */
MJC_EXPORT void mjc_scene_grab(mjcScene* scene, int kind);

/* Move the point that the body is pulled to, as mjc_scene_move_camera does the camera. */
MJC_EXPORT void mjc_scene_drag(mjcScene* scene, int action, double dx, double dy);

/* Write the pull's force to the body's xfrc_applied; call it before each step. A mocap body is
 * moved instead. After letting go it clears the force once. */
MJC_EXPORT void mjc_scene_pull(mjcScene* scene);

#ifdef __cplusplus
}
#endif

#endif /* MJCOURSE_ENGINE_SCENE_H_ */
