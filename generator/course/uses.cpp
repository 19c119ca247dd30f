#include "course/uses.h"

#include <algorithm>
#include <utility>

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

// In the order of the text, whatever the order in which they were found.
void sort(std::vector<Use>& uses, const std::vector<const Lesson*>& pages) {
  const auto place = [&](const Use& use) {
    const auto page = std::find(pages.begin(), pages.end(), use.page) - pages.begin();
    return std::pair(page, use.section == nullptr ? 0 : use.section->line);
  };
  std::sort(uses.begin(), uses.end(),
            [&](const Use& a, const Use& b) { return place(a) < place(b); });
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

std::vector<Use> uses_of_model(const Course& course, const std::string& name) {
  std::vector<Use> uses = uses_of_link(course, "model:" + name);
  for (const Lesson& lesson : course.lessons) {
    if (lesson.front.draft) continue;
    for (const Block& block : lesson.blocks) {
      const LocatedText* model = model_of(block);
      if (model != nullptr && model->text == name) add(uses, lesson, model->span());
    }
  }
  sort(uses, course.pages());
  return uses;
}

void add_uses(std::vector<Use>& uses, const std::vector<PlaceOnPage>& places,
              const Course& course) {
  for (const auto& [page, span] : places) add(uses, *page, span);
  sort(uses, course.pages());
}

const LocatedText* model_of(const Block& block) {
  const LocatedText* model = nullptr;
  if (const auto* lab = std::get_if<Lab>(&block)) model = &lab->model;
  if (const auto* figure = std::get_if<Figure>(&block)) model = &figure->model;
  if (const auto* snippet = std::get_if<Snippet>(&block)) model = &snippet->model;
  if (const auto* excerpt = std::get_if<ModelExcerpt>(&block)) model = &excerpt->model;
  return model == nullptr || model->text.empty() || model->text.starts_with('<') ? nullptr : model;
}

}  // namespace mjcourse
