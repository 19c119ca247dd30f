/* A step begins from these parts and from nothing else. The solver's warm start is one of them:
 * without it a state that is put back goes on with other last bits. */
#include "state.h"

#include <string.h>

typedef struct Part_ {
  mjtNum* numbers;
  int count;
} Part;

enum { PARTS = 11 };

static void find_parts(const mjModel* model, mjData* data, Part parts[PARTS]) {
  const Part found[PARTS] = {
      {&data->time, 1},
      {data->qpos, model->nq},
      {data->qvel, model->nv},
      {data->act, model->na},
      {data->qacc_warmstart, model->nv},
      {data->ctrl, model->nu},
      {data->qfrc_applied, model->nv},
      {data->xfrc_applied, 6 * model->nbody},
      {data->mocap_pos, 3 * model->nmocap},
      {data->mocap_quat, 4 * model->nmocap},
      {data->userdata, model->nuserdata},
  };
  memcpy(parts, found, sizeof found);
}

static size_t bytes(Part part) {
  return (size_t)part.count * sizeof(mjtNum);
}

int mjc_state_size(const mjModel* model) {
  return 1 + model->nq + 2 * model->nv + model->na + model->nu + model->nv + 6 * model->nbody +
         7 * model->nmocap + model->nuserdata;
}

void mjc_get_state(const mjModel* model, const mjData* data, mjtNum* state) {
  Part parts[PARTS];
  find_parts(model, (mjData*)data, parts); /* only read */
  for (int i = 0; i < PARTS; state += parts[i++].count)
    memcpy(state, parts[i].numbers, bytes(parts[i]));
}

void mjc_set_state(const mjModel* model, mjData* data, const mjtNum* state) {
  Part parts[PARTS];
  find_parts(model, data, parts);
  for (int i = 0; i < PARTS; state += parts[i++].count)
    memcpy(parts[i].numbers, state, bytes(parts[i]));
}
