#include "evaluate/warm_header.h"

#include <algorithm>
#include <cctype>

#include "evaluate/leading_includes.h"

namespace mjcourse {
namespace {

enum class Origin { course, eigen, mujoco, standard, other };

Origin origin_of(const Include& include, const IncludeFolders& folders) {
  if (!include.angled) return Origin::other;  // looked for beside the program first
  const std::string& name = include.name;
  if (!folder_with(name, folders).empty()) return Origin::course;
  if (name.starts_with("Eigen/") || name.starts_with("unsupported/Eigen/")) return Origin::eigen;
  if (name == "mujoco/mujoco.h") return Origin::mujoco;
  // <vector>, but not <complex.h>, whose macro `I` changes what Eigen's headers say.
  const bool standard = std::all_of(name.begin(), name.end(), [](unsigned char c) {
    return std::islower(c) != 0 || std::isdigit(c) != 0 || c == '_';
  });
  return standard ? Origin::standard : Origin::other;
}

}  // namespace

std::vector<std::string> warm_roots(std::string_view program, const IncludeFolders& include) {
  std::vector<std::string> course, eigen;
  for (const Include& one : leading_includes(program)) {
    const Origin origin = origin_of(one, include);
    if (origin == Origin::other) break;
    if (origin == Origin::course) course.push_back(one.name);
    if (origin == Origin::eigen) eigen.push_back(one.name);
  }
  return course.empty() ? eigen : course;
}

}  // namespace mjcourse
