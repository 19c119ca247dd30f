// How long the templates of a course's theme may take for a whole site.
//
// Each piece of a page ends after its own time (script/templates.h), but a site has many pieces,
// and a theme may be a stranger's.
#pragma once

#include <chrono>
#include <cstddef>

#include "page/blocks/page_writer.h"

namespace mjcourse {

// As long as the templates of so many lessons may take together, on all threads.
std::chrono::milliseconds time_of_templates(std::size_t lessons);

// The same renderers, which together take no longer than `time`: what comes behind it is an error.
// Nothing where there are none.
RendererOf within(std::chrono::milliseconds time, RendererOf renderer_of);

}  // namespace mjcourse
