// Anchors: the ids by which the pages of a site refer into each other.
#pragma once

#include <cstddef>
#include <string>

#include "findings/claim.h"
#include "lesson/blocks/lesson.h"

namespace mjcourse {

// `text` as a part of an HTML id that any selector can name: "1.2-check" → "1-2-check".
std::string as_id(std::string text);

// What somebody named, as a part of an HTML id and of the addresses that lead to it: "a b" → "a-b".
std::string id_of_name(std::string name);

// On the verification page: of a lesson, "lesson-1-2", and of its claims[index], "lesson-1-2-17".
std::string lesson_anchor(const Lesson& lesson);
std::string claim_anchor(const Lesson& lesson, std::size_t index);

// On the lesson's page: what `claim` is about where it has an id, else the heading above it; ""
// where there is none.
std::string place_anchor(const Lesson& lesson, const Claim& claim);

// "example-NAME"; in a browser with scripts, its line 12 is "NAME-L12"
// (site/browser/client/lines.ts).
std::string example_anchor(const Example& example);
std::string exercise_anchor(const Exercise& exercise);
std::string question_anchor(const Quiz& quiz, std::size_t question);

}  // namespace mjcourse
