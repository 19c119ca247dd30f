#include "physics/object_count.h"

namespace mjcourse {

int object_count(const mjModel& model, mjtObj type) {
  switch (type) {
    case mjOBJ_BODY:
    case mjOBJ_XBODY:
      return model.nbody;
    case mjOBJ_JOINT:
      return model.njnt;
    case mjOBJ_GEOM:
      return model.ngeom;
    case mjOBJ_SITE:
      return model.nsite;
    case mjOBJ_CAMERA:
      return model.ncam;
    case mjOBJ_LIGHT:
      return model.nlight;
    case mjOBJ_MESH:
      return model.nmesh;
    case mjOBJ_SKIN:
      return model.nskin;
    case mjOBJ_HFIELD:
      return model.nhfield;
    case mjOBJ_TEXTURE:
      return model.ntex;
    case mjOBJ_MATERIAL:
      return model.nmat;
    case mjOBJ_PAIR:
      return model.npair;
    case mjOBJ_EXCLUDE:
      return model.nexclude;
    case mjOBJ_EQUALITY:
      return model.neq;
    case mjOBJ_TENDON:
      return model.ntendon;
    case mjOBJ_ACTUATOR:
      return model.nu;
    case mjOBJ_SENSOR:
      return model.nsensor;
    case mjOBJ_NUMERIC:
      return model.nnumeric;
    case mjOBJ_TEXT:
      return model.ntext;
    case mjOBJ_TUPLE:
      return model.ntuple;
    case mjOBJ_KEY:
      return model.nkey;
    case mjOBJ_UNKNOWN:
    case mjOBJ_DOF:
      break;
  }
  return 0;
}

}  // namespace mjcourse
