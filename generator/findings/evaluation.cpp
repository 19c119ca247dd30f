#include "findings/evaluation.h"

#include <utility>

namespace mjcourse {

const LessonResults& Evaluation::results_of(const Course& course, const Lesson& page) const {
  if (course.glossary && &page == &course.glossary->page) return glossary;
  return lessons.at(static_cast<std::size_t>(&page - course.lessons.data()));
}

LessonResults& Evaluation::results_of(const Course& course, const Lesson& page) {
  return const_cast<LessonResults&>(std::as_const(*this).results_of(course, page));
}

}  // namespace mjcourse
