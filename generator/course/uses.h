// Which sections speak of what: the sections of the course that use a term or a model, or link to
// something.
#pragma once

#include <string>
#include <vector>

#include "course/course.h"

namespace mjcourse {

struct Use {
  const Lesson* page;      // a lesson, or the glossary's page
  const Heading* section;  // null before the first heading

  bool operator==(const Use&) const = default;
};

// In the course's order, each section once; drafts are left out. Terms are looked for in lessons
// only, since definitions use each other all the time.
std::vector<Use> uses_of_term(const Course& course, const std::string& key);
std::vector<Use> uses_of_link(const Course& course, const std::string& target);
// Also of those that show it, in a lab or a figure, or speak of it in code.
std::vector<Use> uses_of_model(const Course& course, const std::string& name);

// Of what stands at these places of pages as well, in the course's order.
struct PlaceOnPage {
  const Lesson* page;
  Span span;
};
void add_uses(std::vector<Use>& uses, const std::vector<PlaceOnPage>& places, const Course& course);

// The name of the model that a lab, a figure, a snippet or an excerpt is of; null for other blocks,
// and for a model that stands in the lesson itself.
const LocatedText* model_of(const Block& block);

}  // namespace mjcourse
