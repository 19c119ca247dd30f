#include "course/uses.h"

#include <algorithm>

namespace mjcourse {
namespace {

// The last heading at or above `span`; also for what stands inside a fence.
const Heading* section_at(const Lesson& page, Span span) {
  const int line = page.source->position(span.begin).line;
  const Heading* section = nullptr;
  for (const Heading& heading : page.headings) {
    if (heading.line <= line) section = &heading;
  }
  return section;
}

void add(std::vector<Use>& uses, const Lesson& page, Span span) {
  const Use use{&page, section_at(page, span)};
  if (std::find(uses.begin(), uses.end(), use) == uses.end()) uses.push_back(use);
}

}  // namespace

std::vector<Use> uses_of_term(const Course& course, const std::string& key) {
  std::vector<Use> uses;
  for (const Lesson& lesson : course.lessons) {
    if (lesson.front.draft) continue;
    for (const Block& block : lesson.blocks) {
      const auto* term = std::get_if<TermUse>(&block);
      if (term != nullptr && term->key == key) add(uses, lesson, term->name.span());
    }
  }
  return uses;
}

std::vector<Use> uses_of_link(const Course& course, const std::string& target) {
  std::vector<Use> uses;
  for (const Lesson* page : course.pages()) {
    if (page->front.draft) continue;
    for (const Link& link : page->links) {
      if (link.target.text == target) add(uses, *page, link.target.span());
    }
  }
  return uses;
}

}  // namespace mjcourse
