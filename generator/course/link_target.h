// Where a link of a lesson leads: to the web, to a heading, to another lesson.
#pragma once

#include <optional>
#include <string>

#include "course/course.h"
#include "lesson/reading.h"

namespace mjcourse {

struct LinkTarget {
  const Lesson* lesson = nullptr;  // the lesson linked to; null when the link leaves the course
  std::string anchor;              // the id of a heading in it; may be empty
  std::string url;                 // the address outside, when it leaves
};

// Resolve `target`, as `from` writes it: "1.3", "1.3#anchor", "#anchor", "https://…". A target
// that is not there gives the reason instead: a diagnostic without a place.
struct DeadLink {
  std::string id, message, cure;
};
tl::expected<LinkTarget, DeadLink> resolve_link(const Course& course, const Lesson& from,
                                                const std::string& target);

// That there is no lesson `number`, which `from` speaks of.
DeadLink no_lesson(const Course& course, const Lesson& from, const std::string& number);

}  // namespace mjcourse
