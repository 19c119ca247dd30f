#include "page/home_page.h"

#include <utility>
#include <vector>

#include "page/course_data.h"
#include "page/lesson_pictures.h"
#include "page/verification.h"

namespace mjcourse {
namespace {

using nlohmann::json;

// A lesson's picture, as its card shows it.
json card_poster(const Lesson& lesson, const LessonResults& results) {
  const std::vector<LessonPicture> pictures = pictures_of(lesson, results);
  const LessonPicture* picture = foremost(pictures);
  if (picture == nullptr) return nullptr;
  return {{"webp", picture->path + ".webp"},
          {"png", picture->path + ".png"},
          {"width", picture->poster->width},
          {"height", picture->poster->height},
          {"alt", ""}};
}

}  // namespace

std::string home_page(const Course& course, const Evaluation& evaluation, const Press& press) {
  json levels = json::array();
  Tally total;
  for (const Level& level : course.levels) {
    json lessons = json::array();
    for (const std::size_t index : published(course, level)) {
      const Lesson& lesson = course.lessons[index];
      const LessonResults& results = evaluation.lessons[index];
      const PageWriter writer(course, lesson, results, press);
      total += results.tally;
      json card = reference_to(lesson);
      card["summary"] = writer.inline_html(lesson.front.summary);
      card["minutes"] = lesson.front.minutes ? json(*lesson.front.minutes) : json(nullptr);
      card["poster"] = level.number.empty() ? json(nullptr) : card_poster(lesson, results);
      lessons.push_back(std::move(card));
    }
    levels.push_back({{"folder", level.folder},
                      {"number", level.number},
                      {"title", level.title},
                      {"lessons", std::move(lessons)}});
  }
  total += evaluation.glossary.tally;
  return render_template(
      press.templates, "home",
      {{"course", {{"title", course.title}, {"description", course.description}}},
       {"root", ""},
       {"levels", levels},
       {"verified", verified_data(total, evaluation.versions.mujoco, kVerificationPage)}});
}

}  // namespace mjcourse
