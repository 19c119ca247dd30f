/* The state of a simulation: all that its next step depends on, as numbers that can be kept and put
 * back. Plain C without the browser, so that the tests read the same numbers natively. */
#ifndef MJCOURSE_ENGINE_STATE_H_
#define MJCOURSE_ENGINE_STATE_H_

#include <mujoco/mujoco.h>

#ifdef __cplusplus
extern "C" {
#endif

/* How many numbers it has. */
int mjc_state_size(const mjModel* model);

/* Write them to `state` (mjc_state_size). */
void mjc_get_state(const mjModel* model, const mjData* data, mjtNum* state);

/* Put them back. What follows from them is not computed: forward, or step. */
void mjc_set_state(const mjModel* model, mjData* data, const mjtNum* state);

#ifdef __cplusplus
}
#endif

#endif /* MJCOURSE_ENGINE_STATE_H_ */
