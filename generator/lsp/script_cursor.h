// ScriptCursor: what is being named at the end of a piece of a script: a field of MuJoCo's, or an
// object of the model.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace mjcourse {

struct ScriptCursor {
  enum class Kind { field, object };
  Kind kind = Kind::field;
  std::string of;    // "data", "model", "model.opt"; or the function that takes the object's name
  std::string part;  // of the name, so far
};

// `before`: the script up to the place. Nothing where neither is named.
std::optional<ScriptCursor> script_cursor(std::string_view before);

// The field of MuJoCo's that `text` names around `offset`, as its headers call it: "mjData.qpos"
// for `data.qpos[0]` or `data->qpos`; and where. Nothing where there is none.
struct NamedField {
  std::string name;
  std::size_t begin = 0, end = 0;
};
std::optional<NamedField> field_at(std::string_view text, std::size_t offset);

}  // namespace mjcourse
