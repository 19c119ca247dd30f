#include "page/learner_pages.h"

#include <string>
#include <utility>

#include "base/content_hash.h"
#include "page/course_data.h"
#include "page/html/placeholder.h"
#include "page/html/site_paths.h"
#include "page/site_data.h"

namespace mjcourse {
namespace {

using nlohmann::json;

// The file of the questions of all lessons. A style that one of them has goes into the page's
// sheet.
std::string questions_script(const SiteData& site, const std::vector<LessonParts>& parts,
                             InlineStyles& styles, const Spool& spool) {
  std::string text = "globalThis.mjcourseQuestions=[";
  for (const Level& level : site.course.levels) {
    for (const std::size_t index : published(site.course, level)) {
      if (parts[index].review.size == 0) continue;
      json lesson = json::parse(spool.get(parts[index].review));
      for (json& question : lesson["questions"]) {
        question["html"] = styles.take(question["html"].get<std::string>());
      }
      text += (text.ends_with('[') ? "\n" : ",\n") + lesson.dump();
    }
  }
  return text + "\n];\n";
}

}  // namespace

void write_progress(const SiteData& site, const std::vector<LessonParts>& parts,
                    PageRenderer& renderer, Spool& spool) {
  json levels = json::array();
  std::vector<PagePart> rows;
  for (const Level& level : site.course.levels) {
    PagePart& of_level = rows.emplace_back(PagePart{placeholder(level.folder), {}});
    for (const std::size_t index : published(site.course, level)) {
      of_level.pieces.push_back(parts[index].progress);
    }
    if (of_level.pieces.empty()) continue;
    levels.push_back({{"title", level.title}, {"rows", of_level.mark}});
  }
  const std::string body = render_template(renderer.templates(), "progress",
                                           {{"title", kProgressTitle},
                                            {"course", site.course.title},
                                            {"review", site.asks},
                                            {"levels", std::move(levels)},
                                            {"sheet", site.manifest.at("learner.css")},
                                            {"script", site.manifest.at("progress.js")}});
  renderer.write_long(kProgressPage,
                      {"progress", kProgressTitle,
                       "What this browser remembers of your reading of " + site.course.title + "."},
                      body, rows, spool);
}

void write_review(const SiteData& site, const std::vector<LessonParts>& parts,
                  PageRenderer& renderer, SiteFiles& directory, const Spool& spool) {
  InlineStyles styles;
  const std::string script = questions_script(site, parts, styles, spool);
  const std::string path = "review/questions-" + content_hash(script) + ".js";
  directory.write(path, script);
  const std::string body = render_template(renderer.templates(), "review",
                                           {{"title", kReviewTitle},
                                            {"questions", path},
                                            {"sheet", site.manifest.at("learner.css")},
                                            {"script", site.manifest.at("review.js")}});
  renderer.write(kReviewPage,
                 {"review", kReviewTitle,
                  "Questions of " + site.course.title + " that come again after some days."},
                 body, styles);
}

void write_kept(const SiteData& site, PageRenderer& renderer) {
  InlineStyles styles;
  const std::string body = render_template(renderer.templates(), "kept",
                                           {{"title", kKeptTitle},
                                            {"sheet", site.manifest.at("learner.css")},
                                            {"script", site.manifest.at("kept.js")}});
  renderer.write(
      kKeptPage,
      {"kept", kKeptTitle,
       "What this device keeps of " + site.course.title + ", to be read without a network."},
      body, styles);
}

}  // namespace mjcourse
