#include "lesson/syntax/linked_libraries.h"

#include <algorithm>

#include "lesson/syntax/leading_includes.h"

namespace mjcourse {

bool draws(std::string_view program) {
  return std::ranges::any_of(leading_includes(program),
                             [](const Include& include) { return include.name == "GL/osmesa.h"; });
}

std::vector<std::string> linked_libraries(std::string_view program) {
  std::vector<std::string> libraries{"mujoco"};
  if (draws(program)) libraries.emplace_back("OSMesa");
  return libraries;
}

}  // namespace mjcourse
