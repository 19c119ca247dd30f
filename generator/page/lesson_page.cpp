#include "page/lesson_page.h"

#include <utility>

#include "page/course_data.h"
#include "page/html/anchors.h"
#include "page/html/moved_html.h"
#include "page/html/placeholder.h"
#include "page/html/site_paths.h"
#include "page/html/verification.h"
#include "page/lesson_history.h"
#include "page/site_data.h"

namespace mjcourse {

using nlohmann::json;

namespace {

// A solution has ids that it also has where it is folded away.
std::string answers_of(const json& answers, Templates& templates) {
  if (answers.empty()) return "";
  return moved_html(render_template(templates, "answers", {{"answers", answers}}), {"told-"});
}

}  // namespace

LessonPage lesson_page(const SiteData& site, const Lesson& lesson, std::size_t index,
                       PageWriter& writer, Templates& templates) {
  const Course& course = site.course;
  const Evaluation& evaluation = site.evaluation;
  const LessonResults& results = evaluation.lessons[index];
  std::string prose = writer.body();
  const std::string answers = answers_of(writer.answers(), templates);
  json objectives = json::array(), prerequisites = json::array();
  for (const Document& objective : lesson.front.objectives) {
    objectives.push_back(writer.inline_html(objective));
  }
  for (const LocatedText& number : lesson.front.prerequisites) {
    const Lesson* before = course.find_lesson(number.text);
    if (before != nullptr) prerequisites.push_back(reference_to(*before));
  }
  const Level& level = level_of(course, lesson);
  // The nearest lesson in one direction that the site has; past an end the index wraps to a huge
  // one. From the course no way leads into what stands beside it, nor back.
  const auto neighbour = [&](std::size_t step) {
    std::size_t at = index + step;
    while (at < course.lessons.size() && course.lessons[at].front.draft) at += step;
    const bool there = at < course.lessons.size() &&
                       level_of(course, course.lessons[at]).number.empty() == level.number.empty();
    return there ? reference_to(course.lessons[at]) : json(nullptr);
  };
  std::string body = render_template(
      templates, "lesson",
      {{"number", lesson.number},
       {"title", lesson.front.title.text},
       {"summary", writer.inline_html(lesson.front.summary)},
       {"minutes", lesson.front.minutes ? json(*lesson.front.minutes) : json(nullptr)},
       {"objectives", objectives},
       {"prerequisites", prerequisites},
       {"tags", lesson.front.tags},
       {"contents", writer.contents()},
       {"body", placeholder("prose")},
       {"answers", answers},
       {"verified",
        verified_data(results.tally, evaluation,
                      "../" + std::string(kVerificationPage) + "#" + lesson_anchor(lesson))},
       {"previous", neighbour(std::size_t(0) - 1)},
       {"next", neighbour(1)},
       {"level", {{"title", level.title}, {"href", "index.html#" + level_anchor(level)}}},
       {"history", history_data(site, lesson)},
       {"root", "../"}});
  fill_in(body, "lesson", "body", "prose", prose);
  return {std::move(body), std::move(prose), answers};
}

}  // namespace mjcourse
