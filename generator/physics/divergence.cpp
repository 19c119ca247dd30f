#include "physics/divergence.h"

#include <algorithm>

namespace mjcourse {
namespace {

std::string joint_named(const Model& model, int joint) {
  const std::string name = model.name(mjOBJ_JOINT, joint);
  return name.empty() ? "joint " + std::to_string(joint) : "joint `" + name + "`";
}

// "qpos[3] of joint `free`": an entry of qpos, and the last joint that begins at or before it.
std::string position_entry(const Model& model, int entry) {
  const int* begin = model->jnt_qposadr;
  const auto joint = std::upper_bound(begin, begin + model->njnt, entry) - begin - 1;
  return "qpos[" + std::to_string(entry) + "] of " + joint_named(model, static_cast<int>(joint));
}

// "qvel[2] of joint `hinge`": an entry of `field`, which has one for each degree of freedom.
std::string freedom_entry(const Model& model, const std::string& field, int entry) {
  return field + '[' + std::to_string(entry) + "] of " +
         joint_named(model, model->dof_jntid[entry]);
}

int first_bad(const mjtNum* values, int count) {
  return static_cast<int>(std::find_if(values, values + count, mju_isBad) - values);
}

}  // namespace

std::optional<std::string> find_divergence(const Model& model, const Data& data) {
  const mjWarningStat* warning = data->warning;
  if (warning[mjWARN_BADQPOS].number > 0) {
    return position_entry(model, warning[mjWARN_BADQPOS].lastinfo);
  }
  if (warning[mjWARN_BADQVEL].number > 0) {
    return freedom_entry(model, "qvel", warning[mjWARN_BADQVEL].lastinfo);
  }
  if (warning[mjWARN_BADQACC].number > 0) {
    return freedom_entry(model, "qacc", warning[mjWARN_BADQACC].lastinfo);
  }
  const int position = first_bad(data->qpos, model->nq);
  if (position < model->nq) return position_entry(model, position);
  const int velocity = first_bad(data->qvel, model->nv);
  if (velocity < model->nv) return freedom_entry(model, "qvel", velocity);
  return std::nullopt;
}

}  // namespace mjcourse
