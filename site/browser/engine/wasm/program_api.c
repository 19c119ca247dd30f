#include "program_api.h"

#include <malloc.h>
#include <stdlib.h>

#define FUNCTION(name) {#name, (const void*)&name},
#define VARIABLE(name) {#name, (const void*)&name},

/* The names are read from the header when this is built (mujoco_names.cmake). */
static const mjcSymbol functions[] = {
#include "mujoco_functions.inc"
    /* The program's memory is the engine's: what one allocates, the other may free. */
    {"mjc_malloc", (const void*)&malloc},     {"mjc_free", (const void*)&free},
    {"mjc_calloc", (const void*)&calloc},     {"mjc_realloc", (const void*)&realloc},
    {"mjc_memalign", (const void*)&memalign}, {0, 0},
};

static const mjcSymbol variables[] = {
#include "mujoco_variables.inc"
    {0, 0},
};

const mjcSymbol* mjc_functions(void) {
  return functions;
}

const mjcSymbol* mjc_variables(void) {
  return variables;
}

/* The linker's: where the first variable of the engine is. */
extern char __global_base;

const void* mjc_program_room(void) {
  return &__global_base;
}
