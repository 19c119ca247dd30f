#include "page/long_pages.h"

#include <optional>
#include <ostream>
#include <string>
#include <utility>

#include "page/course_data.h"
#include "page/html/placeholder.h"
#include "page/html/site_paths.h"
#include "page/html/verification.h"
#include "page/site_data.h"
#include "page/verification_page.h"

namespace mjcourse {
namespace {

using nlohmann::json;
using Piece = Spool::Piece;

// The lessons and pages that the site has: all but the drafts.
std::vector<const LessonParts*> published_parts(const SiteData& site,
                                                const std::vector<LessonParts>& parts) {
  const std::vector<const Lesson*> pages = site.course.pages();
  std::vector<const LessonParts*> published;
  for (std::size_t i = 0; i < pages.size(); ++i) {
    if (!pages[i]->front.draft) published.push_back(&parts[i]);
  }
  return published;
}

// verification.json, its lessons each in its place.
void write_json(const json& all, const std::vector<const LessonParts*>& lessons, const Spool& spool,
                SiteFiles& directory) {
  const std::string text = json_file(all);
  const std::string none = "\"lessons\": []";
  const std::size_t place = text.find(none) + none.size() - 1;
  directory.write(kVerificationJson, [&](std::ostream& file) {
    file << text.substr(0, place);
    const char* before = "\n";
    for (const LessonParts* lesson : lessons) {
      file << std::exchange(before, ",\n") << indented(spool.get(lesson->json), 2);
    }
    if (!lessons.empty()) file << "\n ";
    file << text.substr(place);
  });
}

}  // namespace

void write_home(const SiteData& site, const std::vector<LessonParts>& parts, PageRenderer& renderer,
                Spool& spool) {
  const Course& course = site.course;
  json levels = json::array();
  std::vector<PagePart> cards;
  std::optional<SharedPicture> picture;
  Tally total = site.evaluation.glossary.tally;
  for (const Level& level : course.levels) {
    PagePart& of_level = cards.emplace_back(PagePart{placeholder(level.folder), {}});
    for (const std::size_t index : published(course, level)) {
      of_level.pieces.push_back(parts[index].card);
      if (!picture) picture = parts[index].picture;
      total += site.evaluation.lessons[index].tally;
    }
    levels.push_back({{"id", level_anchor(level)},
                      {"number", level.number},
                      {"title", level.title},
                      {"cards", of_level.mark}});
  }
  const std::string body =
      render_template(renderer.templates(), "home",
                      {{"course", {{"title", course.title}, {"description", course.description}}},
                       {"root", ""},
                       {"script", site.manifest.at("home.js")},
                       {"print", site.prints ? kPrintPage : ""},
                       {"levels", std::move(levels)},
                       {"verified", verified_data(total, site.evaluation, kVerificationPage)}});
  renderer.write_long("index.html",
                      {"home", course.title, course.description, "", nullptr, std::move(picture)},
                      body, cards, spool);
}

void write_verification(const SiteData& site, const std::vector<LessonParts>& parts,
                        PageRenderer& renderer, SiteFiles& directory, Spool& spool) {
  const std::vector<const LessonParts*> lessons = published_parts(site, parts);
  json all = verification_of_none(site.course.title, site.evaluation.versions);
  PagePart open{placeholder("open"), {}}, sections{placeholder("lessons"), {}};
  const auto add = [](PagePart& part, Piece piece) {
    if (piece.size > 0) part.pieces.push_back(piece);
  };
  for (const LessonParts* lesson : lessons) {
    add_counts(all["counts"], lesson->counts);
    add(sections, lesson->section);
    add(open, lesson->asserted);
  }
  for (const LessonParts* lesson : lessons) add(open, lesson->unchecked);
  write_json(all, lessons, spool, directory);
  json data = verification_data(all, true, {});
  if (!open.pieces.empty()) data["open_parts"] = open.mark;
  data["lesson_parts"] = sections.mark;
  renderer.write_long(
      kVerificationPage,
      {"verification", "What was verified", "What this course states, and how it was checked."},
      render_template(renderer.templates(), "verification", data), {open, sections}, spool);
}

}  // namespace mjcourse
