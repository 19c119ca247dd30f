// The picture files of a lesson's labs and figures, each in a folder of the lesson's own.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "findings/lesson_results.h"
#include "findings/result.h"
#include "lesson/blocks/lesson.h"

namespace mjcourse {

struct LessonPicture {
  std::string path;  // without the extension
  const Poster* poster;
  const Blob* film;  // null for a lab
  std::string alt;   // what it shows, in words
};

// In the order of the blocks. They point into `results`.
std::vector<LessonPicture> pictures_of(const Lesson& lesson, const LessonResults& results);

// The picture that stands for the lesson: its first lab's, else its first figure's; null where it
// has none.
const LessonPicture* foremost(const std::vector<LessonPicture>& pictures);

// The same for other sites, which show pages by their pictures: a PNG below the site's root.
struct SharedPicture {
  std::string path;
  int width = 0, height = 0;  // its own pixels
  std::string alt;
};
std::optional<SharedPicture> shared_picture(const Lesson& lesson, const LessonResults& results);

}  // namespace mjcourse
