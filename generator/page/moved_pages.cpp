#include "page/moved_pages.h"

#include <optional>
#include <string>

#include "course/former_page.h"
#include "course/language.h"
#include "page/blocks/page_writer.h"
#include "page/html/site_paths.h"
#include "page/site_data.h"

namespace mjcourse {
namespace {

void write_moved_page(const SiteData& site, const Lesson& lesson, const std::string& former,
                      Templates& templates, SiteFiles& directory) {
  const Course& course = site.course;
  directory.write(former, render_template(templates, "moved",
                                          {{"course",
                                            {{"title", course.title},
                                             {"language", course.language},
                                             {"right_to_left", is_right_to_left(course.language)}}},
                                           {"title", lesson.number + " " + lesson.front.title.text},
                                           {"href", "../" + site_address(page_path(lesson))},
                                           {"address", web_address(course, page_path(lesson))},
                                           {"root", "../"},
                                           {"assets",
                                            {{"css", site.manifest.at("site.css")},
                                             {"js", site.manifest.at("moved.js")},
                                             {"favicon", site.manifest.at("favicon.svg")}}}}));
}

}  // namespace

void write_moved_pages(const SiteData& site, Templates& templates, SiteFiles& directory) {
  for (const Lesson& lesson : site.course.lessons) {
    if (lesson.front.draft) continue;
    for (const LocatedText& written : lesson.front.formerly) {
      const std::optional<std::string> former = former_page(lesson, written.text);
      if (former) write_moved_page(site, lesson, *former, templates, directory);
    }
  }
}

}  // namespace mjcourse
