/* The fields of mjVisual and mjStatistic, for which mjxmacro.h has no list.
 *
 * The one list kept by hand; a test compares its size with that of the structs. Each is
 * X(struct inside mjVisual, field) or X(field of mjStatistic). */
#ifndef MJCOURSE_PHYSICS_VISUAL_FIELDS_H_
#define MJCOURSE_PHYSICS_VISUAL_FIELDS_H_

/* clang-format off */
#define MJC_VISUAL_FIELDS                                                                   \
  X(global, fovy) X(global, ipd) X(global, azimuth) X(global, elevation)                    \
  X(global, linewidth) X(global, glow) X(global, offwidth) X(global, offheight)             \
  X(quality, shadowsize) X(quality, offsamples) X(quality, numslices)                       \
  X(quality, numstacks) X(quality, numquads)                                                \
  X(headlight, ambient) X(headlight, diffuse) X(headlight, specular) X(headlight, active)   \
  X(map, stiffness) X(map, stiffnessrot) X(map, force) X(map, torque) X(map, alpha)         \
  X(map, fogstart) X(map, fogend) X(map, znear) X(map, zfar) X(map, haze)                   \
  X(map, shadowclip) X(map, shadowscale) X(map, actuatortendon)                             \
  X(scale, forcewidth) X(scale, contactwidth) X(scale, contactheight) X(scale, connect)     \
  X(scale, com) X(scale, camera) X(scale, light) X(scale, selectpoint)                      \
  X(scale, jointlength) X(scale, jointwidth) X(scale, actuatorlength)                       \
  X(scale, actuatorwidth) X(scale, framelength) X(scale, framewidth) X(scale, constraint)   \
  X(scale, slidercrank)                                                                     \
  X(rgba, fog) X(rgba, haze) X(rgba, force) X(rgba, inertia) X(rgba, joint)                 \
  X(rgba, actuator) X(rgba, actuatornegative) X(rgba, actuatorpositive) X(rgba, com)        \
  X(rgba, camera) X(rgba, light) X(rgba, selectpoint) X(rgba, connect)                      \
  X(rgba, contactpoint) X(rgba, contactforce) X(rgba, contactfriction)                      \
  X(rgba, contacttorque) X(rgba, contactgap) X(rgba, rangefinder) X(rgba, constraint)       \
  X(rgba, slidercrank) X(rgba, crankbroken)

#define MJC_STATISTIC_FIELDS \
  X(meaninertia) X(meanmass) X(meansize) X(extent) X(center)
/* clang-format on */

#endif /* MJCOURSE_PHYSICS_VISUAL_FIELDS_H_ */
