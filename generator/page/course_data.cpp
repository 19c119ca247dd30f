#include "page/course_data.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "course/link_target.h"
#include "page/html/anchors.h"
#include "page/html/site_paths.h"

namespace mjcourse {

using nlohmann::json;

namespace {

// How many lessons each page lists; in a longer course it links so many levels on either side.
constexpr std::size_t kFewLessons = 100, kNearLevels = 3;

json lessons_data(const Course& course, const Level& level, const Lesson* current) {
  json lessons = json::array();
  for (const std::size_t index : published(course, level)) {
    json lesson = reference_to(course.lessons[index]);
    lesson["current"] = &course.lessons[index] == current;
    lessons.push_back(std::move(lesson));
  }
  return lessons;
}

// Which of the course's levels it is in.
std::size_t level_index(const Course& course, const Lesson& lesson) {
  const auto found = std::ranges::find(course.levels, lesson.folder, &Level::folder);
  return static_cast<std::size_t>(found - course.levels.begin());
}

}  // namespace

const Level& level_of(const Course& course, const Lesson& lesson) {
  return course.levels.at(level_index(course, lesson));
}

std::string level_anchor(const Level& level) {
  return "level-" + id_of_name(level.folder) + "-title";
}

std::vector<std::size_t> published(const Course& course, const Level& level) {
  std::vector<std::size_t> lessons;
  std::copy_if(level.lessons.begin(), level.lessons.end(), std::back_inserter(lessons),
               [&](std::size_t index) { return !course.lessons[index].front.draft; });
  return lessons;
}

bool has_questions(const Course& course) {
  const auto asks = [](const Block& block) {
    return std::holds_alternative<Quiz>(block) || std::holds_alternative<Exercise>(block);
  };
  return std::any_of(course.lessons.begin(), course.lessons.end(), [&](const Lesson& lesson) {
    return !lesson.front.draft && std::any_of(lesson.blocks.begin(), lesson.blocks.end(), asks);
  });
}

json reference_to(const Lesson& lesson) {
  return {{"number", lesson.number},
          {"title", lesson.front.title.text},
          {"href", site_address(page_path(lesson))}};
}

json levels_data(const Course& course, const Lesson* current) {
  const bool few = course.lessons.size() <= kFewLessons;
  const std::size_t own = current == nullptr ? 0 : level_index(course, *current);
  json levels = json::array();
  for (std::size_t i = 0; i < course.levels.size(); ++i) {
    const Level& level = course.levels[i];
    const bool beside = level.number.empty();
    const bool near = i + kNearLevels >= own && i <= own + kNearLevels;
    const bool open = few || (current != nullptr && i == own);
    if (!few && !near && !beside) continue;
    levels.push_back({{"title", level.title},
                      {"beside", beside},
                      {"href", open ? "" : "index.html#" + level_anchor(level)},
                      {"lessons", open ? lessons_data(course, level, current) : json::array()}});
  }
  return levels;
}

json pages_data(const Course& course, const Evaluation& evaluation, bool asks,
                const std::string& kind) {
  json pages = json::array();
  if (course.glossary) {
    const Lesson& glossary = course.glossary->page;
    pages.push_back({{"title", glossary.front.title.text},
                     {"href", page_path(glossary)},
                     {"current", kind == "glossary"}});
  }
  if (!evaluation.api.empty()) {
    pages.push_back({{"title", kApiTitle}, {"href", kApiPage}, {"current", kind == "api"}});
  }
  if (!evaluation.models.empty()) {
    pages.push_back(
        {{"title", kGalleryTitle}, {"href", kGalleryPage}, {"current", kind == "gallery"}});
  }
  if (asks) {
    pages.push_back(
        {{"title", kReviewTitle}, {"href", kReviewPage}, {"current", kind == "review"}});
  }
  pages.push_back(
      {{"title", kProgressTitle}, {"href", kProgressPage}, {"current", kind == "progress"}});
  pages.push_back({{"title", kKeptTitle}, {"href", kKeptPage}, {"current", kind == "kept"}});
  return pages;
}

json verified_data(const Tally& tally, const Evaluation& evaluation, const std::string& href) {
  return {{"programs", tally.programs},
          {"in_page", tally.in_page},
          {"exercises", tally.exercises},
          {"snippets", tally.snippets},
          {"commands", tally.commands},
          {"outputs", tally.outputs},
          {"values", tally.values},
          {"listed_models", tally.listed_models},
          {"unchecked", tally.unchecked},
          {"answers_proved", tally.answers_proved},
          {"answers_asserted", tally.answers_asserted},
          {"labs", tally.labs},
          {"pictures", tally.pictures},
          {"plots", tally.plots},
          {"formulas", tally.formulas},
          {"provisional", evaluation.open_in_page > 0},
          {"mujoco", evaluation.versions.mujoco},
          {"href", href}};
}

}  // namespace mjcourse
