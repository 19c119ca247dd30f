#include "cli/letter_names.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include "base/folded_name.h"
#include "base/running_text.h"

namespace mjcourse {
namespace {

constexpr std::size_t kMostOfName = 200;

std::string file_name(const std::string& student) {
  std::string name;
  for (const std::filesystem::path& part : std::filesystem::path(student).lexically_normal()) {
    if (part.empty() || part == "." || part == ".." || part == "/") continue;
    name += (name.empty() ? "" : "_") + part.string();
  }
  if (name.size() > kMostOfName) name = beginning_of(name, kMostOfName);
  // A listing leaves out what begins with a dot.
  if (name.empty() || name.starts_with('.')) name.replace(0, name.empty() ? 0 : 1, "_");
  return name;
}

}  // namespace

std::vector<std::string> letter_names(const std::vector<std::string>& students) {
  std::vector<std::string> names;
  std::set<std::string> known;
  for (const std::string& student : students) {
    const std::string name = file_name(student);
    std::string own = name;
    for (int i = 2; !known.insert(folded_name(own)).second; ++i) {
      own = name + "-" + std::to_string(i);
    }
    names.push_back(own + ".md");
  }
  return names;
}

}  // namespace mjcourse
