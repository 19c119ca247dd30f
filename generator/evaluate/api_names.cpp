#include "evaluate/api_names.h"

#include <nlohmann/json.hpp>
#include <string>

namespace mjcourse {
namespace {

// As CodeMirror calls them, which has an icon for each.
const char* kind_name(ApiName::Kind kind) {
  switch (kind) {
    case ApiName::Kind::function:
      return "function";
    case ApiName::Kind::field:
      return "property";
    case ApiName::Kind::constant:
    case ApiName::Kind::macro:
      return "constant";
    case ApiName::Kind::variable:
      return "variable";
    case ApiName::Kind::structure:
    case ApiName::Kind::enumeration:
    case ApiName::Kind::type:
      break;
  }
  return "type";
}

// Without its semicolon; a structure's whole text is nothing for a line.
std::string in_one_line(std::string declaration) {
  if (declaration.find('\n') != std::string::npos) return "";
  if (declaration.ends_with(';')) declaration.pop_back();
  return declaration;
}

}  // namespace

std::string api_names(const MujocoApi& api) {
  nlohmann::json names = nlohmann::json::array();
  for (const auto& [name, found] : api) {
    names.push_back({name, kind_name(found.kind), in_one_line(found.declaration), found.comment});
  }
  return names.dump();
}

}  // namespace mjcourse
