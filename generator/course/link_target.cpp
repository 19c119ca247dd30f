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

DeadLink no_lesson(const Course& course, const Lesson& from, const std::string& number) {
  std::vector<std::string> others;
  for (const Lesson& lesson : course.lessons) {
    if (&lesson != &from) others.push_back(lesson.number);
  }
  return {"E-link-dead", "there is no lesson `" + number + "` in this course",
          others.empty() ? "add it to content/course.yaml" : suggest(number, others)};
}

tl::expected<LinkTarget, DeadLink> resolve_link(const Course& course, const Lesson& from,
                                                const std::string& target) {
  for (const char* outside : {"https://", "http://", "mailto:"}) {
    if (target.starts_with(outside)) return LinkTarget{nullptr, "", target};
  }
  if (target.starts_with("#")) return heading_of(from, target.substr(1));
  for (const char* later : {"model:", "api:"}) {
    if (!target.starts_with(later)) continue;
    return tl::unexpected(DeadLink{"E-not-yet",
                                   "links to `" + std::string(later) +
                                       "` belong to the lesson "
                                       "language, but this version of mjcourse cannot do them yet",
                                   "write the name as code for now"});
  }
  const std::size_t hash = std::min(target.find('#'), target.size());
  const std::string number = target.substr(0, hash);
  if (const Lesson* lesson = course.find_lesson(number)) {
    if (lesson->front.draft && !from.front.draft) {
      return tl::unexpected(DeadLink{"E-link-dead",
                                     "lesson " + number + " is a draft, and not in the site",
                                     "link to it when its `draft` is gone"});
    }
    return heading_of(*lesson, hash < target.size() ? target.substr(hash + 1) : "");
  }
  static const std::regex lesson_number(R"((\d+|[A-Z])\.\d+)");
  if (std::regex_match(number, lesson_number))
    return tl::unexpected(no_lesson(course, from, number));
  return tl::unexpected(DeadLink{"E-link-dead", "`" + target + "` leads nowhere",
                                 "a link leads to a lesson (`1.3`, `1.3#heading`), to a heading of "
                                 "its own page (`#heading`) or to the web (`https://…`)"});
}

}  // namespace mjcourse
