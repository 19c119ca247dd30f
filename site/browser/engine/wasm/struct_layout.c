#include "struct_layout.h"

#include <stddef.h>

/* The type of a member, one or an array of it; the pointer form matches arrays. */
#define TYPE_OF(member)             \
  _Generic((member),                \
      int: mjcFIELD_INT,            \
      float: mjcFIELD_FLOAT,        \
      double: mjcFIELD_DOUBLE,      \
      unsigned char: mjcFIELD_BYTE, \
      float*: mjcFIELD_FLOAT,       \
      double*: mjcFIELD_DOUBLE,     \
      char*: mjcFIELD_CHAR)
#define SIZE_OF(member)          \
  sizeof(_Generic((member),      \
      int: (int)0,               \
      float: (float)0,           \
      double: (double)0,         \
      unsigned char: (mjtByte)0, \
      float*: (float)0,          \
      double*: (double)0,        \
      char*: (char)0))
#define MEMBER(type, name)                                          \
  {                                                                 \
    #name, TYPE_OF(((type*)0)->name), (int)offsetof(type, name),    \
        (int)(sizeof(((type*)0)->name) / SIZE_OF(((type*)0)->name)) \
  }

#define X(name) MEMBER(mjvGeom, name)
static const mjcMember geom[] = {X(type),     X(dataid),     X(objtype),     X(objid), X(category),
                                 X(texid),    X(texuniform), X(texcoord),    X(segid), X(texrepeat),
                                 X(size),     X(pos),        X(mat),         X(rgba),  X(emission),
                                 X(specular), X(shininess),  X(reflectance), X(label)};
#undef X

#define X(name) MEMBER(mjvLight, name)
static const mjcMember light[] = {X(pos),       X(dir),         X(attenuation), X(cutoff),
                                  X(exponent),  X(ambient),     X(diffuse),     X(specular),
                                  X(headlight), X(directional), X(castshadow)};
#undef X

#define X(name) MEMBER(mjvGLCamera, name)
static const mjcMember view[] = {
    X(pos),         X(forward),      X(up),         X(frustum_center), X(frustum_bottom),
    X(frustum_top), X(frustum_near), X(frustum_far)};
#undef X

#define X(name) MEMBER(mjvCamera, name)
static const mjcMember camera[] = {X(type),     X(fixedcamid), X(trackbodyid), X(lookat),
                                   X(distance), X(azimuth),    X(elevation)};
#undef X

#define LAYOUT(type, members) \
  { #type, sizeof(type), sizeof(members) / sizeof(mjcMember), members }
static const mjcLayout layouts[] = {LAYOUT(mjvGeom, geom), LAYOUT(mjvLight, light),
                                    LAYOUT(mjvGLCamera, view), LAYOUT(mjvCamera, camera)};

const mjcLayout* mjc_layout(int index) {
  return index < (int)(sizeof layouts / sizeof layouts[0]) ? &layouts[index] : NULL;
}
