#include "page/blocks/lesson_context.h"

#include <algorithm>
#include <utility>

#include "page/html/site_paths.h"

namespace mjcourse {

LessonContext::LessonContext(const Course& of_course, const Lesson& of_lesson,
                             const LessonResults& of_results, PageContext of_page)
    : course(of_course), lesson(of_lesson), results(of_results), page(std::move(of_page)) {
  if (page.page.empty()) page.page = page_path(lesson);
}

std::string LessonContext::from_root(const std::string& path) const {
  return way_to_root(page.page) + site_address(path);
}

std::string LessonContext::unique_id(const std::string& wanted) {
  const auto is_taken = [this](const std::string& id) {
    return ids_.contains(id) ||
           std::any_of(lesson.headings.begin(), lesson.headings.end(),
                       [&](const Heading& heading) { return heading.id == id; });
  };
  std::string id = wanted;
  for (int n = 2; is_taken(id); ++n) id = wanted + "-" + std::to_string(n);
  ids_.insert(id);
  return id;
}

void LessonContext::list_heading(int level, const std::string& id, const std::string& title) {
  nlohmann::json entry{{"id", id}, {"title", title}, {"children", nlohmann::json::array()}};
  if (level == 2 || contents.empty()) {
    contents.push_back(std::move(entry));
  } else if (level == 3) {
    contents.back()["children"].push_back(std::move(entry));
  }
}

}  // namespace mjcourse
