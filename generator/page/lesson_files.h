// A lesson's part of the site: its page, and the files that this shows.
// Tested by tests/generator/cli/build_test.cpp.
#pragma once

#include <cstddef>
#include <vector>

#include "page/blocks/lab_module.h"
#include "page/lesson_parts.h"
#include "page/page_renderer.h"
#include "page/printed_course.h"
#include "page/site_data.h"

namespace mjcourse {

// Write all of lesson `index`. Where `parts` is given, it gets what the pages that list all lessons
// have of it, and `printed` grows by what is printed. Safe on several threads at once, each with
// its own `renderer` and its own lessons.
void write_lesson(const SiteData& site, std::size_t index, PageRenderer& renderer,
                  SiteFiles& directory, Spool& spool, PrintedLength& printed, LessonParts* parts);

void write_labs(const std::vector<LabFiles>& labs, SiteFiles& directory);

// The pictures that the author put beside `page`, whichever page of the course that is.
void copy_images(const Lesson& page, const LessonResults& results, SiteFiles& directory);

}  // namespace mjcourse
