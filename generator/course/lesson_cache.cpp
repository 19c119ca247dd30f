#include "course/lesson_cache.h"

#include <utility>

#include "course/course.h"

namespace mjcourse {

std::optional<Lesson> LessonCache::take(const std::string& path, std::string_view bytes,
                                        const Typography& typography) {
  const std::lock_guard lock(mutex_);
  const auto found = lessons_.find(path);
  if (found == lessons_.end() || found->second.source->text() != bytes ||
      found->second.typography != typography) {
    return std::nullopt;
  }
  return std::move(lessons_.extract(found).mapped());
}

void LessonCache::give_back(Course& course) {
  const std::lock_guard lock(mutex_);
  for (Lesson& lesson : course.lessons) {
    // What is unloaded is read again, and so is what has to be said once more.
    if (lesson.kept != Lesson::Kept::all || !lesson.sound) continue;
    const std::string path = lesson.source->path();
    lessons_.insert_or_assign(path, std::move(lesson));
  }
}

}  // namespace mjcourse
