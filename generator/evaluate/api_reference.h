// The names of MuJoCo's that the course links to, `[text](api:mj_step)`, held against its headers.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "course/course.h"
#include "physics/mujoco_api.h"
#include "report/diagnostic.h"

namespace mjcourse {

struct ApiEntry {
  std::string name;         // "mj_step", "mjModel.nq"
  std::string kind;         // in words: "function", "field of mjModel"
  std::string declaration;  // C, as the header has it
  std::string comment;      // the header's; may be empty
  std::string header;       // "mujoco.h"
  std::string section;      // of the header; may be empty
  std::string url;          // of MuJoCo's own documentation; may be empty
};

// Each name once, in the order of its letters; those that only drafts link to are checked and left
// out. `headers` is asked for MuJoCo's names only when there is such a link.
using MujocoHeaders = std::function<const tl::expected<MujocoApi, std::string>&()>;
std::vector<ApiEntry> evaluate_api(const Course& course, const MujocoHeaders& headers,
                                   Diagnostics& diagnostics);

}  // namespace mjcourse
