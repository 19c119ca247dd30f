#include "evaluate/linked_libraries.h"

#include <algorithm>

#include "evaluate/leading_includes.h"

namespace mjcourse {

std::vector<std::string> linked_libraries(std::string_view program) {
  std::vector<std::string> libraries{"mujoco"};
  const auto includes = leading_includes(program);
  const auto draws = [](const Include& include) { return include.name == "GL/osmesa.h"; };
  if (std::ranges::any_of(includes, draws)) libraries.emplace_back("OSMesa");
  return libraries;
}

}  // namespace mjcourse
