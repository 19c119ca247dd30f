#include "page/lesson_pictures.h"

#include <algorithm>

namespace mjcourse {
namespace {

std::string folder_of(const Lesson& lesson) {
  return lesson.folder + "/" + lesson.slug + "/";
}

}  // namespace

std::string poster_path(const Lesson& lesson, int lab) {
  return folder_of(lesson) + "lab-" + std::to_string(lab);
}

std::string figure_path(const Lesson& lesson, int figure) {
  return folder_of(lesson) + "figure-" + std::to_string(figure);
}

std::vector<LessonPicture> pictures_of(const Lesson& lesson, const LessonResults& results) {
  std::vector<LessonPicture> pictures;
  int labs = 0, figures = 0;
  for (std::size_t i = 0; i < lesson.blocks.size(); ++i) {
    if (std::holds_alternative<Lab>(lesson.blocks[i])) {
      ++labs;
      const auto* lab = results.get<LabResult>(i);
      if (lab == nullptr || !lab->poster) continue;
      pictures.push_back({poster_path(lesson, labs), &*lab->poster, nullptr});
    } else if (std::holds_alternative<Figure>(lesson.blocks[i])) {
      ++figures;
      const auto* figure = results.get<FigureResult>(i);
      if (figure == nullptr) continue;
      pictures.push_back({figure_path(lesson, figures), &figure->poster, &figure->film});
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
