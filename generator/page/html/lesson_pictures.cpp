#include "page/html/lesson_pictures.h"

#include <algorithm>

#include "page/html/site_paths.h"

namespace mjcourse {

std::vector<LessonPicture> pictures_of(const Lesson& lesson, const LessonResults& results) {
  std::vector<LessonPicture> pictures;
  for (std::size_t i = 0; i < lesson.blocks.size(); ++i) {
    const auto* lab = results.get<LabResult>(i);
    const auto* figure = results.get<FigureResult>(i);
    if (lab != nullptr && lab->poster) {
      pictures.push_back(
          {block_path(lesson, i), &*lab->poster, nullptr, std::get<Lab>(lesson.blocks[i]).alt});
    } else if (figure != nullptr) {
      pictures.push_back({block_path(lesson, i), &figure->poster, &figure->film,
                          std::get<Figure>(lesson.blocks[i]).alt});
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

std::optional<SharedPicture> shared_picture(const Lesson& lesson, const LessonResults& results) {
  const std::vector<LessonPicture> pictures = pictures_of(lesson, results);
  const LessonPicture* picture = foremost(pictures);
  if (picture == nullptr) return std::nullopt;
  const Poster& poster = *picture->poster;
  return SharedPicture{picture->path + ".png", 2 * poster.width, 2 * poster.height, picture->alt};
}

}  // namespace mjcourse
