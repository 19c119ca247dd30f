// The pages of what a reader's browser remembers: how far each lesson was read, the questions that
// come again after some days, and the pages that can be read without a network.
//
// The generator knows nothing of readers. It lists what there is to be remembered, and the pages'
// own scripts (site/browser/client/progress, site/browser/client/review,
// site/browser/client/offline) say what was.
// Tested by tests/site/review.mjs.
#pragma once

#include <vector>

#include "page/lesson_parts.h"
#include "page/page_renderer.h"
#include "page/site_data.h"

namespace mjcourse {

// `parts` are those of the lessons, by their index.
void write_progress(const SiteData& site, const std::vector<LessonParts>& parts,
                    PageRenderer& renderer, Spool& spool);

// With the file of all questions: a script and no JSON, as a page that was opened from the disk can
// load nothing else. It calls itself `mjcourseQuestions`; site/browser/client/review/deck.ts says
// what it is.
void write_review(const SiteData& site, const std::vector<LessonParts>& parts,
                  PageRenderer& renderer, SiteFiles& directory, const Spool& spool);

void write_kept(const SiteData& site, PageRenderer& renderer);

}  // namespace mjcourse
