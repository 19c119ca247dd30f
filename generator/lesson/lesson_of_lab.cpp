#include "lesson/lesson_of_lab.h"

#include <memory>

#include "lesson/blocks/lesson_reader.h"

namespace mjcourse {

Lesson lesson_of_lab(const std::string& name, const std::string& fence, Diagnostics& mistakes) {
  Lesson lesson;
  lesson.folder = "models";
  lesson.slug = lesson.number = name;
  lesson.source = std::make_shared<SourceText>("the page of models/" + name + ".xml", fence);
  lesson.document = parse_markdown(fence);
  Reading reading(*lesson.source, mistakes);
  LessonReader(lesson, reading).read_document();
  return lesson;
}

}  // namespace mjcourse
