/* What a picture of a simulation may show beside the bodies: body frames, joint axes, contacts …
 *
 * Each overlay has a name that lessons use and is one setting of MuJoCo's mjvOption. The table
 * is plain C because the browser's engine compiles the same file: a poster and the live view then
 * show the same things under the same names. */
#ifndef MJCOURSE_PHYSICS_OVERLAY_TABLE_H_
#define MJCOURSE_PHYSICS_OVERLAY_TABLE_H_

#include <mujoco/mujoco.h>

#ifdef __cplusplus
extern "C" {
#endif

/* NOLINTBEGIN(modernize-use-using): C has no other way */
typedef enum mjcOverlayKind_ {
  mjcOVERLAY_FLAG = 0, /* one of mjvOption.flags; any number may be on */
  mjcOVERLAY_FRAME,    /* a value of mjvOption.frame: at most one is on */
  mjcOVERLAY_LABEL     /* a value of mjvOption.label: at most one is on */
} mjcOverlayKind;

typedef struct mjcOverlay_ {
  const char* name;
  mjcOverlayKind kind;
  int value; /* mjtVisFlag, mjtFrame or mjtLabel */
} mjcOverlay;
/* NOLINTEND(modernize-use-using) */

/* The overlays, `*count` of them. */
const mjcOverlay* mjc_overlays(int* count);

/* Switch `overlay` on or off in `option`. A frame or label that is switched on replaces the one
 * before; one that is switched off leaves another's alone. */
void mjc_set_overlay(mjvOption* option, const mjcOverlay* overlay, int on);
/* Is `overlay` on in `option`? Of MuJoCo's defaults some are. */
int mjc_shows_overlay(const mjvOption* option, const mjcOverlay* overlay);

#ifdef __cplusplus
}
#endif

#endif /* MJCOURSE_PHYSICS_OVERLAY_TABLE_H_ */
