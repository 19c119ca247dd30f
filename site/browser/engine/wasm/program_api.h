/* What a reader's program is linked with: MuJoCo's C interface by name, as the engine has it.
 *
 * The program is a module of its own that shares the engine's memory and table (../../cpp/). Its
 * stack and its variables lie in the room below those of the engine. */
#ifndef MJCOURSE_PROGRAM_API_H_
#define MJCOURSE_PROGRAM_API_H_

#include "engine.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A name, and a function's index in the table or a variable's place in memory; the last is {0, 0}.
 */
typedef struct mjcSymbol_ {
  const char* name;
  const void* place;
} mjcSymbol;

/* The functions of mujoco.h, but for those of the renderer, and those of malloc.h as mjc_malloc
 * etc. */
MJC_EXPORT const mjcSymbol* mjc_functions(void);

/* The variables of mujoco.h. */
MJC_EXPORT const mjcSymbol* mjc_variables(void);

/* Where the program's room ends, which begins at 0. */
MJC_EXPORT const void* mjc_program_room(void);

#ifdef __cplusplus
}
#endif

#endif /* MJCOURSE_PROGRAM_API_H_ */
