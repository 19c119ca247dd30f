#include "page/web_files.h"

#include <algorithm>
#include <utility>

#include "base/running_text.h"
#include "course/link_target.h"
#include "page/html/site_paths.h"
#include "page/html/verification.h"
#include "page/lesson_history.h"
#include "page/site_data.h"

namespace mjcourse {
namespace {

using nlohmann::json;

constexpr const char* kSitemap = "sitemap.xml";
// A feed tells what is new. The sitemap has all of a long course.
constexpr std::size_t kMostNews = 50;
constexpr std::size_t kMostShortName = 16;  // characters, which OpenSearch wants of a ShortName

struct News {
  std::string time;
  std::size_t lesson;  // its index
};

std::vector<News> news_of(const SiteData& site) {
  std::vector<News> news;
  const std::vector<Lesson>& lessons = site.course.lessons;
  for (std::size_t i = 0; i < lessons.size(); ++i) {
    const LastChange* change = last_change(site, lessons[i]);
    if (change != nullptr && !lessons[i].front.draft) news.push_back({change->time, i});
  }
  // Lessons of one commit stay in the course's order.
  std::ranges::stable_sort(news, std::greater(), &News::time);
  return news;
}

// All pages but those at former addresses, in the order in which the site lists them.
json sitemap_pages(const SiteData& site) {
  const Course& course = site.course;
  json pages = json::array();
  const auto add = [&](const std::string& path, const LastChange* change = nullptr) {
    pages.push_back({{"address", web_address(course, path)},
                     {"changed", change != nullptr ? change->time : ""}});
  };
  add("index.html");
  for (const Lesson& lesson : course.lessons) {
    if (!lesson.front.draft) add(page_path(lesson), last_change(site, lesson));
  }
  if (course.glossary) {
    add(page_path(course.glossary->page), last_change(site, course.glossary->page));
  }
  if (!site.evaluation.api.empty()) add(kApiPage);
  if (!site.evaluation.models.empty()) add(kGalleryPage);
  for (const ModelPage& model : site.evaluation.models) add(model_page_path(model.name));
  if (site.asks) add(kReviewPage);
  add(kProgressPage);
  add(kKeptPage);
  add(kVerificationPage);
  add(kSearchPage);
  if (site.prints) add(kPrintPage);
  return pages;
}

}  // namespace

bool has_feed(const SiteData& site) {
  return !site.course.url.empty() && !news_of(site).empty();
}

std::string feed_entry(const SiteData& site, const Lesson& lesson, const std::string& summary,
                       Templates& templates) {
  const LastChange* change = last_change(site, lesson);
  if (!site.feed || change == nullptr) return "";
  return render_template(templates, "feed-entry",
                         {{"address", web_address(site.course, page_path(lesson))},
                          {"title", lesson.number + " " + lesson.front.title.text},
                          {"changed", change->time},
                          {"summary", summary}});
}

void write_web_files(const SiteData& site, const std::vector<LessonParts>& parts,
                     Templates& templates, SiteFiles& directory, const Spool& spool) {
  const Course& course = site.course;
  if (course.url.empty()) return;
  directory.write(kSitemap,
                  render_template(templates, "sitemap", {{"pages", sitemap_pages(site)}}));
  directory.write("robots.txt",
                  "User-agent: *\nAllow: /\n\nSitemap: " + web_address(course, kSitemap) + "\n");
  directory.write(kOpenSearch,
                  render_template(templates, "opensearch",
                                  {{"title", beginning_of(course.title, kMostShortName)},
                                   {"description", course.title},
                                   {"language", course.language},
                                   {"address", web_address(course, kSearchPage)}}));
  if (!site.feed) return;
  std::vector<News> news = news_of(site);
  news.resize(std::min(news.size(), kMostNews));
  std::string entries;
  for (const News& one : news) entries += spool.get(parts[one.lesson].news);
  directory.write(kFeed, render_template(templates, "feed",
                                         {{"title", course.title},
                                          {"description", course.description},
                                          {"language", course.language},
                                          {"address", course.url},
                                          {"feed", web_address(course, kFeed)},
                                          {"changed", news.front().time},
                                          {"entries", entries}}));
}

}  // namespace mjcourse
