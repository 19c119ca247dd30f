// What the search of the pages looks through: two scripts below the site's root.
//
//   search.js         names the other one and the search's own code; small, always asked for anew
//   search-HASH.js    mjcourse.pages = […]: all text, page by page, in the shape that
//                     site/browser/client/search/pages.ts has. Its name is made of its content, so
//                     a browser may keep it for ever
//
// They are scripts and not JSON, since a page that was opened from the disk may load nothing else;
// and pages do not name the hash themselves, or each edit would change all of them.
// Tested by tests/site/search.mjs.
#pragma once

#include <cstddef>
#include <vector>

#include "page/html/site_files.h"
#include "page/lesson_parts.h"
#include "page/site_data.h"

namespace mjcourse {

// So many bytes of text a browser can look through at ease. In a course that has more, the index
// has of each lesson an equal share: its titles, and the beginnings of its sections.
inline constexpr std::size_t kMostSearchText = 8 << 20;
std::size_t search_share(const Course& course);  // of one lesson

// The index's piece of `lesson`, which has at most so many bytes of text; its hash goes with it.
void add_search_part(const Lesson& lesson, const LessonResults& results, std::size_t most,
                     Spool& spool, LessonParts& parts);

// `parts` are those of the lessons, by their index.
void write_search_index(const SiteData& site, const std::vector<LessonParts>& parts,
                        const Spool& spool, SiteFiles& directory);

}  // namespace mjcourse
