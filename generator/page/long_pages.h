// The pages that list all lessons, put together of what each lesson gave (page/lesson_parts.h).
// Tested by tests/site/verification.mjs.
#pragma once

#include <vector>

#include "page/lesson_parts.h"
#include "page/page_renderer.h"
#include "page/site_data.h"

namespace mjcourse {

// `parts` are those of the lessons, by their index, and behind them the glossary's, where there is
// one. Those of drafts are empty.
void write_home(const SiteData& site, const std::vector<LessonParts>& parts, PageRenderer& renderer,
                Spool& spool);
void write_verification(const SiteData& site, const std::vector<LessonParts>& parts,
                        PageRenderer& renderer, SiteFiles& directory, Spool& spool);

}  // namespace mjcourse
