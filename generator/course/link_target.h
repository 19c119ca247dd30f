// Where a link of a lesson leads: to the web, to a heading, to another lesson, to the page of a
// model or of MuJoCo's names. Terms lead to the glossary.
#pragma once

#include <optional>
#include <string>

#include "course/course.h"
#include "lesson/syntax/reading.h"

namespace mjcourse {

struct LinkTarget {
  const Lesson* lesson = nullptr;  // the lesson linked to; null when it is something else
  std::string anchor;              // the id of a heading in it; may be empty
  std::string url;                 // the address outside, when it leaves the course
  std::string page = {};           // a page that was made of no lesson, below the site's root
};

// Resolve `target`, as `from` writes it: "1.3", "1.3#anchor", "#anchor", "https://…",
// "model:joint_zoo", "api:mj_step". A target that is not there gives the reason instead: a
// diagnostic without a place. Whether MuJoCo has a name is for evaluating to find out.
struct DeadLink {
  std::string id, message, cure;
};
tl::expected<LinkTarget, DeadLink> resolve_link(const Course& course, const Lesson& from,
                                                const std::string& target);

// That there is no lesson `number`, which `from` speaks of, or none in the site; nothing where
// there is.
std::optional<DeadLink> dead_lesson(const Course& course, const Lesson& from,
                                    const std::string& number);

// That the glossary has no such term, or that there is no glossary; nothing where all is well.
std::optional<DeadLink> unknown_term(const Course& course, const TermUse& term);

// The pages of a model and of MuJoCo's names, and the id of a name on that.
std::string model_page_path(const std::string& model);
inline constexpr const char* kApiPage = "api.html";
std::string api_id(const std::string& name);

}  // namespace mjcourse
