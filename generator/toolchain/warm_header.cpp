#include "toolchain/warm_header.h"

#include <algorithm>
#include <cctype>
#include <set>
#include <utility>

#include "base/cpp_includes.h"
#include "base/files.h"

namespace mjcourse {
namespace {

enum class Origin { course, eigen, plain, standard, other };

// C headers that neither use names of the others nor change what these say.
bool is_plain(const std::string& name) {
  return name == "mujoco/mujoco.h" || name == "mujoco/mjxmacro.h" || name == "GL/osmesa.h";
}

Origin origin_of(const Include& include, const IncludeFolders& folders) {
  if (!include.angled) return Origin::other;  // looked for beside the program first
  const std::string& name = include.name;
  if (!folder_with(name, folders).empty()) return Origin::course;
  if (name.starts_with("Eigen/") || name.starts_with("unsupported/Eigen/")) return Origin::eigen;
  if (is_plain(name)) return Origin::plain;
  // <vector>, but not <complex.h>, whose macro `I` changes what Eigen's headers say.
  const bool standard = std::all_of(name.begin(), name.end(), [](unsigned char c) {
    return std::islower(c) != 0 || std::isdigit(c) != 0 || c == '_';
  });
  return standard ? Origin::standard : Origin::other;
}

struct Leading {
  std::vector<std::string> course, eigen;
};

Leading leading_of(std::string_view text, const IncludeFolders& folders) {
  Leading leading;
  for (const Include& one : leading_includes(text)) {
    const Origin origin = origin_of(one, folders);
    if (origin == Origin::other) break;
    if (origin == Origin::course) leading.course.push_back(one.name);
    if (origin == Origin::eigen) leading.eigen.push_back(one.name);
  }
  return leading;
}

// The header of the course that `name` begins with, or that one begins with, and so on.
std::string root_of(std::string name, const IncludeFolders& folders) {
  std::set<std::string> seen;
  while (seen.insert(name).second) {
    const auto text = DiskFiles(folder_with(name, folders)).read(name);
    const Leading leading = text ? leading_of(*text, folders) : Leading{};
    if (leading.course.empty()) break;
    name = leading.course.front();
  }
  return name;
}

}  // namespace

std::vector<std::string> warm_roots(std::string_view program, const IncludeFolders& include) {
  const Leading leading = leading_of(program, include);
  std::vector<std::string> roots;
  for (const std::string& header : leading.course) {
    std::string root = root_of(header, include);
    if (std::ranges::find(roots, root) == roots.end()) roots.push_back(std::move(root));
  }
  return roots.empty() ? leading.eigen : roots;
}

}  // namespace mjcourse
