// What the contacts between the fingers of pick_place.xml and an object do: the
// sums that lesson 5.1 watches while the arm works.
//
//   const Grasp grasp = grasp_of(model, data, cube);  // the number of its geom
//   std::printf("friction lifts %.2f N\n", grasp.lifts);
#pragma once

#include <mjcourse/mjcourse.hpp>

namespace mjcourse {

struct Grasp {
  double press = 0;  // of both pads together, N
  double lifts = 0;  // the upward part of friction, N
  double could = 0;  // the friction that this pressing allows, N
  double share = 0;  // of its cone, used by the contact that uses most
};

// Whether a contact is one between a finger and the object.
inline bool holds(const mjModel* model, const mjContact& contact, int object) {
  if (contact.geom1 != object && contact.geom2 != object) return false;
  const int other = contact.geom1 == object ? contact.geom2 : contact.geom1;
  const int body = model->geom_bodyid[other];
  return body == id_of(model, mjOBJ_BODY, "finger_left") ||
         body == id_of(model, mjOBJ_BODY, "finger_right");
}

inline Grasp grasp_of(const mjModel* model, const mjData* data, int object) {
  Grasp grasp;
  for (int i = 0; i < data->ncon; ++i) {
    const mjContact& contact = data->contact[i];
    if (!holds(model, contact, object)) continue;
    double force[6];  // normal, two tangents, three torques; on geom2
    mj_contactForce(model, data, i, force);
    double used = 0;  // squared
    for (int k = 1; k < contact.dim; ++k)
      used += std::pow(force[k] / contact.friction[k - 1], 2);
    const double* up = contact.frame + 2;  // z of each of its three axes
    const double lift = force[1] * up[3] + force[2] * up[6];
    grasp.press += force[0];
    grasp.could += contact.friction[0] * force[0];
    grasp.lifts += contact.geom2 == object ? lift : -lift;
    if (force[0] > 0)
      grasp.share = std::max(grasp.share, std::sqrt(used) / force[0]);
  }
  return grasp;
}

}  // namespace mjcourse
