// LessonCache: lessons that were read, for a session that reads a course again after each save.
//
// A lesson is in the cache or in one course, never in two, since the writer of its page changes its
// trees for that time. So each goes back when its course is of no more use.
#pragma once

#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

#include "lesson/blocks/lesson.h"

namespace mjcourse {

struct Course;

class LessonCache {
 public:
  // The lesson that is read out of `bytes`, where it is here. From any thread, as give_back().
  std::optional<Lesson> take(const std::string& path, std::string_view bytes,
                             const Typography& typography = {});
  // Of a course that nobody looks at any more; what it has of lessons is left without its content.
  void give_back(Course& course);

 private:
  std::mutex mutex_;
  std::map<std::string, Lesson> lessons_;  // by their files
};

}  // namespace mjcourse
