#include "course/link_target.h"

#include <algorithm>
#include <regex>

#include "base/nearest.h"

namespace mjcourse {
namespace {

tl::expected<LinkTarget, DeadLink> heading_of(const Lesson& lesson, const std::string& anchor) {
  std::vector<std::string> ids;
  for (const Heading& heading : lesson.headings) ids.push_back(heading.id);
  if (!anchor.empty() && std::find(ids.begin(), ids.end(), anchor) == ids.end()) {
    return tl::unexpected(DeadLink{"E-link-anchor",
                                   "lesson " + lesson.number + " has no heading `#" + anchor + "`",
                                   suggest(anchor, ids)});
  }
  return LinkTarget{&lesson, anchor, ""};
}

}  // namespace

tl::expected<LinkTarget, DeadLink> resolve_link(const Course& course, const Lesson& from,
                                                const std::string& target) {
  static const std::regex outside(R"((https?://|mailto:).*)");
  if (std::regex_match(target, outside)) return LinkTarget{nullptr, "", target};
  if (target.starts_with("#")) return heading_of(from, target.substr(1));
  for (const char* later : {"model:", "api:"}) {
    if (!target.starts_with(later)) continue;
    return tl::unexpected(DeadLink{"E-not-yet",
                                   "links to `" + std::string(later) + "` belong to the lesson "
                                   "language, but this version of mjcourse cannot do them yet",
                                   "write the name as code for now"});
  }
  const std::size_t hash = std::min(target.find('#'), target.size());
  const std::string number = target.substr(0, hash);
  if (const Lesson* lesson = course.find_lesson(number)) {
    return heading_of(*lesson, hash < target.size() ? target.substr(hash + 1) : "");
  }
  std::vector<std::string> numbers;
  for (const Lesson& lesson : course.lessons) numbers.push_back(lesson.number);
  return tl::unexpected(DeadLink{"E-link-dead", "there is no lesson `" + number + "` in this course",
                                 suggest(number, numbers)});
}

}  // namespace mjcourse
