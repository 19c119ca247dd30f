/* Where the members of MuJoCo's structs lie, so that a page reads them in place. */
#ifndef MJCOURSE_ENGINE_STRUCT_LAYOUT_H_
#define MJCOURSE_ENGINE_STRUCT_LAYOUT_H_

#include <emscripten/emscripten.h>

#include "physics/field_table.h"

typedef struct mjcMember_ {
  const char* name; /* MuJoCo's */
  mjcFieldType type;
  int offset; /* bytes from the struct's beginning */
  int count;  /* numbers, or characters */
} mjcMember;

typedef struct mjcLayout_ {
  const char* name; /* MuJoCo's name of the struct, "mjvGeom" */
  int size;         /* bytes from one struct of an array to the next */
  int count;        /* members */
  const mjcMember* members;
} mjcLayout;

/* Layout `index`; NULL past the last. */
EMSCRIPTEN_KEEPALIVE const mjcLayout* mjc_layout(int index);

#endif /* MJCOURSE_ENGINE_STRUCT_LAYOUT_H_ */
