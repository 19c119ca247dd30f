// What several templates are told of the course: its lessons, its other pages, what was verified.
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "findings/evaluation.h"

namespace mjcourse {

const Level& level_of(const Course& course, const Lesson& lesson);
// The lessons of a level that the site has: all but the drafts.
std::vector<std::size_t> published(const Course& course, const Level& level);

// Whether the site has a question to come back to.
bool has_questions(const Course& course);

// Of its heading on the home page.
std::string level_anchor(const Level& level);

// A lesson to link to.
nlohmann::json reference_to(const Lesson& lesson);
// The list of lessons beside the page of `current`, or of another page where that is null. In a
// course of more than a hundred lessons, that is those of its level, and links to the levels around
// it, so that a page's size does not depend on the course's.
nlohmann::json levels_data(const Course& course, const Lesson* current);
// What the list of lessons offers beside them, on a page of this kind; `asks`: has_questions(),
// which looks at all lessons.
nlohmann::json pages_data(const Course& course, const Evaluation& evaluation, bool asks,
                          const std::string& kind);
// `href` leads to the same on the verification page.
nlohmann::json verified_data(const Tally& tally, const Evaluation& evaluation,
                             const std::string& href);

}  // namespace mjcourse
