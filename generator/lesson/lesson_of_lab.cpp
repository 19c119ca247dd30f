#include "lesson/lesson_of_lab.h"

#include <memory>

#include "lesson/blocks/lesson_reader.h"

namespace mjcourse {

std::shared_ptr<const Lesson> lesson_of_lab(const std::string& name, const std::string& fence) {
  auto made = std::make_shared<Lesson>();
  Lesson& lesson = *made;
  lesson.folder = "models";
  lesson.slug = lesson.number = name;
  lesson.source = std::make_shared<SourceText>("the page of models/" + name + ".xml", fence);
  lesson.document = parse_markdown(fence);
  Diagnostics mistakes;
  Reading reading(*lesson.source, mistakes);
  LessonReader(lesson, reading).read_document();
  lesson.sound = mistakes.empty();
  return made;
}

}  // namespace mjcourse
