#include "cli/skeleton.h"

#include <regex>
#include <stdexcept>

namespace mjcourse {

std::string filled_skeleton(const Files& assets, const std::string& path,
                            const std::map<std::string, std::string>& marks) {
  const auto skeleton = assets.read("skeleton/" + path);
  if (!skeleton) throw std::runtime_error("the skeletons are not installed: " + skeleton.error());
  static const std::regex form("@([a-z_]+)@");
  std::string filled;
  auto behind = skeleton->cbegin();
  for (std::sregex_iterator mark(skeleton->begin(), skeleton->end(), form), end; mark != end;
       ++mark) {
    const auto text = marks.find((*mark)[1]);
    if (text == marks.end()) {
      throw std::runtime_error("skeleton/" + path + " has the mark " + mark->str() +
                               ", which means nothing");
    }
    filled.append(behind, (*mark)[0].first).append(text->second);
    behind = (*mark)[0].second;
  }
  return filled.append(behind, skeleton->cend());
}

}  // namespace mjcourse
