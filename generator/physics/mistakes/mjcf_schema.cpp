#include "physics/mistakes/mjcf_schema.h"

#include <mujoco/mujoco.h>

#include <algorithm>
#include <map>
#include <set>
#include <sstream>
#include <utility>

namespace mjcourse {
namespace {

using Schema = std::map<std::string, std::set<std::string>>;  // element → attributes

// MuJoCo prints a table: on the left an element, indented by its depth, with the number of its
// occurrences; from column 30 on its attributes, over as many lines as they need.
Schema read_schema() {
  constexpr std::size_t left = 30;
  std::string text(1 << 16, '\0');
  mj_printSchema(nullptr, text.data(), static_cast<int>(text.size()), 0, 0);
  std::istringstream lines(text.c_str());
  Schema schema;
  std::string element;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream(line.substr(0, left)) >> element;
    std::istringstream attributes(line.substr(std::min(left, line.size())));
    std::set<std::string>& known = schema[element];
    for (std::string attribute; attributes >> attribute;) known.insert(attribute);
  }
  // One row stands for two elements, of which `worldbody` has no attributes.
  schema["body"] = std::exchange(schema["(world)body"], {});
  schema["worldbody"];
  schema.erase("(world)body");
  return schema;
}

const Schema& schema() {
  static const Schema read = read_schema();
  return read;
}

}  // namespace

std::vector<std::string> mjcf_elements() {
  std::vector<std::string> names;
  for (const auto& [element, attributes] : schema()) names.push_back(element);
  return names;
}

std::vector<std::string> mjcf_attributes(const std::string& element) {
  const auto found = schema().find(element);
  if (found == schema().end()) return {};
  return {found->second.begin(), found->second.end()};
}

}  // namespace mjcourse
