#include "physics/overlay_table.h"

static const mjcOverlay overlays[] = {
    {"frames", mjcOVERLAY_FRAME, mjFRAME_BODY},
    {"geom-frames", mjcOVERLAY_FRAME, mjFRAME_GEOM},
    {"site-frames", mjcOVERLAY_FRAME, mjFRAME_SITE},
    {"contact-frames", mjcOVERLAY_FRAME, mjFRAME_CONTACT},
    {"world-frame", mjcOVERLAY_FRAME, mjFRAME_WORLD},
    {"labels", mjcOVERLAY_LABEL, mjLABEL_BODY},
    {"joint-labels", mjcOVERLAY_LABEL, mjLABEL_JOINT},
    {"geom-labels", mjcOVERLAY_LABEL, mjLABEL_GEOM},
    {"site-labels", mjcOVERLAY_LABEL, mjLABEL_SITE},
    {"force-labels", mjcOVERLAY_LABEL, mjLABEL_CONTACTFORCE},
    {"joints", mjcOVERLAY_FLAG, mjVIS_JOINT},
    {"contacts", mjcOVERLAY_FLAG, mjVIS_CONTACTPOINT},
    {"forces", mjcOVERLAY_FLAG, mjVIS_CONTACTFORCE},
    {"com", mjcOVERLAY_FLAG, mjVIS_COM},
    {"inertia", mjcOVERLAY_FLAG, mjVIS_INERTIA},
    {"tendons", mjcOVERLAY_FLAG, mjVIS_TENDON},
    {"actuators", mjcOVERLAY_FLAG, mjVIS_ACTUATOR},
    {"constraints", mjcOVERLAY_FLAG, mjVIS_CONSTRAINT},
    {"connections", mjcOVERLAY_FLAG, mjVIS_AUTOCONNECT},
    {"transparent", mjcOVERLAY_FLAG, mjVIS_TRANSPARENT},
    {"hulls", mjcOVERLAY_FLAG, mjVIS_CONVEXHULL},
    {"cameras", mjcOVERLAY_FLAG, mjVIS_CAMERA},
    {"lights", mjcOVERLAY_FLAG, mjVIS_LIGHT},
};

const mjcOverlay* mjc_overlays(int* count) {
  *count = (int)(sizeof overlays / sizeof overlays[0]);
  return overlays;
}

/* `setting` is a choice of one value, 0 being none. */
static void choose(int* setting, int value, int on) {
  if (on) {
    *setting = value;
  } else if (*setting == value) {
    *setting = 0;
  }
}

void mjc_set_overlay(mjvOption* option, const mjcOverlay* overlay, int on) {
  switch (overlay->kind) {
    case mjcOVERLAY_FLAG:
      option->flags[overlay->value] = on ? 1 : 0;
      break;
    case mjcOVERLAY_FRAME:
      choose(&option->frame, overlay->value, on);
      break;
    case mjcOVERLAY_LABEL:
      choose(&option->label, overlay->value, on);
      break;
  }
}

int mjc_shows_overlay(const mjvOption* option, const mjcOverlay* overlay) {
  switch (overlay->kind) {
    case mjcOVERLAY_FRAME:
      return option->frame == overlay->value;
    case mjcOVERLAY_LABEL:
      return option->label == overlay->value;
    default:
      return option->flags[overlay->value];
  }
}
