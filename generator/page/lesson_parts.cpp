#include "page/lesson_parts.h"

#include <string>
#include <utility>
#include <vector>

#include "page/course_data.h"
#include "page/html/lesson_pictures.h"
#include "page/html/site_paths.h"
#include "page/html/still_data.h"
#include "page/verification_page.h"

namespace mjcourse {
namespace {

using nlohmann::json;

// A lesson's picture, as its card shows it.
json card_poster(const Lesson& lesson, const LessonResults& results, Loaded loaded) {
  const std::vector<LessonPicture> pictures = pictures_of(lesson, results);
  const LessonPicture* picture = foremost(pictures);
  if (picture == nullptr) return nullptr;
  return still_data(picture->path, picture->poster->width, picture->poster->height, "", loaded);
}

// Those of `claims`, as claim.hbs wants them, that came to `status`.
Spool::Piece list_of(const json& claims, const char* status, Templates& templates, Spool& spool) {
  json listed = json::array();
  for (const json& claim : claims) {
    if (claim["status"] == status) listed.push_back(claim);
  }
  if (listed.empty()) return {};
  return spool.put(render_template(templates, "claims", {{"claims", std::move(listed)}}));
}

}  // namespace

std::string home_card(const Lesson& lesson, const LessonResults& results, CardPlace place,
                      const PageWriter& writer, Templates& templates) {
  json card = reference_to(lesson);
  card["summary"] = writer.inline_html(lesson.front.summary);
  card["minutes"] = lesson.front.minutes ? json(*lesson.front.minutes) : json(nullptr);
  const Loaded loaded = place == CardPlace::first ? Loaded::at_once : Loaded::when_near;
  card["poster"] =
      place == CardPlace::beside ? json(nullptr) : card_poster(lesson, results, loaded);
  return render_template(templates, "card", card);
}

std::string progress_row(const Lesson& lesson, const AskedOfReader& asked, Templates& templates) {
  json row = reference_to(lesson);
  row["questions"] = asked.questions;
  row["exercises"] = asked.exercises;
  return render_template(templates, "progress-row", row);
}

std::string review_json(const Lesson& lesson, const AskedOfReader& asked, Templates& templates) {
  const std::string href = site_address(page_path(lesson));
  json cards = json::array();
  for (const json& question : asked.questions) {
    cards.push_back(
        {{"id", question["id"]}, {"html", render_template(templates, "question", question)}});
  }
  for (json exercise : asked.exercises) {
    exercise["href"] = href;
    cards.push_back(
        {{"id", exercise["id"]}, {"html", render_template(templates, "exercise-again", exercise)}});
  }
  if (cards.empty()) return "";
  return json{{"href", href},
              {"name", lesson.number + " " + lesson.front.title.text},
              {"questions", std::move(cards)}}
      .dump();
}

LessonParts verification_parts(const Lesson& lesson, const Claims& claims, Templates& templates,
                               Spool& spool) {
  json all = verification_of_none("", {});
  const json& own = all["lessons"].emplace_back(verification_of(lesson, claims));
  LessonParts parts;
  parts.json = spool.put(json_text(own));
  parts.counts = counts_of(claims);
  const json data = verification_data(all, true, {});
  parts.asserted = list_of(data["open"], "asserted", templates, spool);
  parts.unchecked = list_of(data["open"], "unchecked", templates, spool);
  parts.section = spool.put(render_template(templates, "verified-lesson", data["lessons"][0]));
  return parts;
}

}  // namespace mjcourse
