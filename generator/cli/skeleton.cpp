#include "cli/skeleton.h"

#include <re2/re2.h>

#include <stdexcept>

namespace mjcourse {

std::string filled_skeleton(const Files& assets, const std::string& path,
                            const std::map<std::string, std::string>& marks) {
  const auto skeleton = assets.read("skeleton/" + path);
  if (!skeleton) throw std::runtime_error("the skeletons are not installed: " + skeleton.error());
  static const RE2 form("(?s)(.*?)@([a-z_]+)@");
  std::string filled;
  re2::StringPiece rest(*skeleton);
  for (std::string before, mark; RE2::Consume(&rest, form, &before, &mark);) {
    const auto text = marks.find(mark);
    if (text == marks.end()) {
      throw std::runtime_error("skeleton/" + path + " has the mark @" + mark +
                               "@, which means nothing");
    }
    filled.append(before).append(text->second);
  }
  return filled.append(rest.data(), rest.size());
}

}  // namespace mjcourse
