// The files of a site that other sites read: its pages for search engines, its lessons for readers
// that follow its changes. Only a course that has an address has them.
#pragma once

#include <string>
#include <vector>

#include "page/html/site_files.h"
#include "page/lesson_parts.h"
#include "page/site_data.h"

namespace mjcourse {

// Whether there is a lesson to tell of: one whose last change is known.
bool has_feed(const SiteData& site);

// The entry of `lesson` in the feed; "" where it has none.
std::string feed_entry(const SiteData& site, const Lesson& lesson, const std::string& summary,
                       Templates& templates);

// sitemap.xml, robots.txt, what browsers are told of the search and, where there is one, the feed
// of the lessons that changed last. `parts` are the lessons'.
void write_web_files(const SiteData& site, const std::vector<LessonParts>& parts,
                     Templates& templates, SiteFiles& directory, const Spool& spool);

}  // namespace mjcourse
