// The names of MuJoCo's C interface: functions, types, fields, constants, as its headers declare
// them.
//
// Enter at read_mujoco_api(). The headers are the authority, and their comments the explanation:
// there is no list of ours. They keep to a few plain forms (a comment above each function, one
// behind each field), which is all that is understood here; it is no C parser.
#pragma once

#include <map>
#include <string>
#include <tl/expected.hpp>

#include "base/files.h"

namespace mjcourse {

struct ApiName {
  enum class Kind { function, structure, field, enumeration, constant, type, macro, variable };
  Kind kind = Kind::function;
  std::string declaration;  // as the header has it, without its comments where it is one line
  std::string comment;      // the header's, in one line; may be empty
  std::string header;       // "mujoco.h"
  std::string section;      // of the header: "Main simulation"; may be empty
  std::string owner;        // of a field or an enumeration's constant: "mjModel", "mjtJoint"
};

// By name: "mj_step", "mjModel", "mjModel.nq", "mjVisual.global.fovy", "mjtJoint", "mjJNT_FREE".
using MujocoApi = std::map<std::string, ApiName>;

// The names in one header, added to `api`.
void read_api_header(const std::string& header, const std::string& text, MujocoApi& api);

// All of mujoco.h and the headers that it includes, below `headers` as "mujoco/mujoco.h". The error
// names the file that could not be read.
tl::expected<MujocoApi, std::string> read_mujoco_api(const Files& headers);

// Where the headers lie: the environment's MJCOURSE_HEADERS, else what the generator was built
// with.
std::string mujoco_headers_folder();

// Those there, read when they are first asked for. From any thread.
const tl::expected<MujocoApi, std::string>& installed_mujoco_api();

}  // namespace mjcourse
