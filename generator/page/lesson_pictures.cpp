#include "page/lesson_pictures.h"

#include <algorithm>

#include "page/site_paths.h"

namespace mjcourse {

std::vector<LessonPicture> pictures_of(const Lesson& lesson, const LessonResults& results) {
  std::vector<LessonPicture> pictures;
  for (std::size_t i = 0; i < lesson.blocks.size(); ++i) {
    const auto* lab = results.get<LabResult>(i);
    const auto* figure = results.get<FigureResult>(i);
    if (lab != nullptr && lab->poster) {
      pictures.push_back({block_path(lesson, i), &*lab->poster, nullptr});
    } else if (figure != nullptr) {
      pictures.push_back({block_path(lesson, i), &figure->poster, &figure->film});
    }
  }
  return pictures;
}

const LessonPicture* foremost(const std::vector<LessonPicture>& pictures) {
  if (pictures.empty()) return nullptr;
  const auto lab = std::find_if(pictures.begin(), pictures.end(), [](const LessonPicture& picture) {
    return picture.film == nullptr;
  });
  return lab != pictures.end() ? &*lab : &pictures.front();
}

}  // namespace mjcourse
