/* What the page calls: the generator's own Simulation behind functions of C.
 *
 * A page gathers the files of a model (mjc_add_file), loads one of them (mjc_load) and moves the
 * simulation that it gets. Loading and moving are the generator's code (generator/physics/), so a
 * mistake in a model has the same line and words here as in a build, and a simulation that diverges
 * stops at the same step.
 *
 * Text is UTF-8 and ends with a zero. Text and arrays that are returned belong to the engine: text
 * lasts until the next call, arrays as long as the simulation; a page reads them before it calls
 * again, since any call may move the memory as JavaScript sees it. */
#ifndef MJCOURSE_ENGINE_H_
#define MJCOURSE_ENGINE_H_

#include <emscripten/emscripten.h>
#include <mujoco/mujoco.h>

#ifdef __cplusplus
extern "C" {
#endif

#define MJC_EXPORT EMSCRIPTEN_KEEPALIVE

typedef struct mjcSimulation_ mjcSimulation;

/* Loading. */

/* Add a file for the next mjc_load; `bytes` (size) are copied. */
MJC_EXPORT void mjc_add_file(const char* name, const char* bytes, int size);

/* The simulation of the model in the file `name`, in its initial state and forwarded; the files are
 * forgotten. NULL when the model is wrong: mjc_load_error says how. Free it with mjc_free. */
MJC_EXPORT mjcSimulation* mjc_load(const char* name);

typedef struct mjcLoadError_ {
  const char* file; /* as it was added */
  const char* message;
  const char* cure; /* "" when there is nothing to suggest */
  int line;         /* from 1; 0 where MuJoCo does not know */
  int column;       /* the same */
} mjcLoadError;

/* Why the last mjc_load gave NULL. */
MJC_EXPORT const mjcLoadError* mjc_load_error(void);

/* What MuJoCo's compiler warned of, a line each; "" when it had nothing to say. */
MJC_EXPORT const char* mjc_warnings(const mjcSimulation* simulation);

MJC_EXPORT void mjc_free(mjcSimulation* simulation);

/* Moving. None of these does anything once the simulation has stopped, but for the resets. */

MJC_EXPORT void mjc_step(mjcSimulation* simulation, int count);
MJC_EXPORT void mjc_forward(mjcSimulation* simulation);
MJC_EXPORT void mjc_reset(mjcSimulation* simulation);
/* Returns what is wrong with `key`; NULL when nothing is. */
MJC_EXPORT const char* mjc_reset_to_keyframe(mjcSimulation* simulation, int key);

/* The first thing that went wrong since the last reset; NULL when nothing did. */
MJC_EXPORT const char* mjc_trouble(mjcSimulation* simulation);

/* The text of an error that MuJoCo raised out of one of its own functions, which reach JavaScript
 * as the number `exception`. The engine works on; the data at hand may be half changed: reset it.
 */
MJC_EXPORT const char* mjc_exception_text(void* exception);

/* Looking. */

MJC_EXPORT mjModel* mjc_model(mjcSimulation* simulation);
MJC_EXPORT mjData* mjc_data(mjcSimulation* simulation);

/* How many objects of a type (mjtObj) there are. */
MJC_EXPORT int mjc_object_count(const mjcSimulation* simulation, int type);

#ifdef __cplusplus
}
#endif

#endif /* MJCOURSE_ENGINE_H_ */
