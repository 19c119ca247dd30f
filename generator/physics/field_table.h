/* Every array and number of mjModel and mjData, by the name that MuJoCo gives it.
 *
 * Scripts name MuJoCo's own fields (`data.qpos`, `model.jnt_qposadr`, `model.opt.timestep`). The
 * table is expanded from MuJoCo's mjxmacro.h, so that no list of arrays is kept by hand. It is
 * plain C because the browser's engine compiles the same file: an expression then means the same in
 * both worlds. */
#ifndef MJCOURSE_PHYSICS_FIELD_TABLE_H_
#define MJCOURSE_PHYSICS_FIELD_TABLE_H_

#include <mujoco/mujoco.h>

#ifdef __cplusplus
extern "C" {
#endif

/* NOLINTBEGIN(modernize-use-using): C has no other way */
typedef enum mjcFieldType_ {
  mjcFIELD_DOUBLE = 0, /* mjtNum */
  mjcFIELD_FLOAT,
  mjcFIELD_INT,
  mjcFIELD_BYTE, /* mjtByte, an unsigned char */
  mjcFIELD_CHAR  /* text: names, paths */
} mjcFieldType;

typedef struct mjcField_ {
  const char* owner; /* "" for the struct itself; "opt", "vis.global", "stat" … inside it */
  const char* name;  /* MuJoCo's name of the field */
  mjcFieldType type;
  void* address; /* the first element; owned by the model or data; unspecified with no elements */
  int rows;      /* elements are (rows x columns), row major; a scalar is (1 x 1) */
  int columns;
  int scalar; /* 1 when the field is a number and not an array */
} mjcField;
/* NOLINTEND(modernize-use-using) */

/* Write up to `capacity` fields of `model` to `fields` and return how many there are. */
int mjc_model_fields(mjModel* model, mjcField* fields, int capacity);

/* The same for `data`, made for `model`. Left out are the arrays of structs: contact, warning,
 * timer, solver. Arrays over constraints (efc_…) have room for njmax rows, of which MuJoCo fills
 * the first data.nefc. */
int mjc_data_fields(const mjModel* model, mjData* data, mjcField* fields, int capacity);

#ifdef __cplusplus
}
#endif

#endif /* MJCOURSE_PHYSICS_FIELD_TABLE_H_ */
