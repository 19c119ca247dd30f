// The page of all models: a picture of each, its sizes, and the lessons that are about it.
// Tested by tests/site/checks/references.mjs.
#pragma once

#include <string>

#include "findings/evaluation.h"
#include "page/blocks/page_writer.h"

namespace mjcourse {

// The page's body; `context` is that of models.html.
std::string gallery_page(const Course& course, const Evaluation& evaluation,
                         const PageContext& context);

}  // namespace mjcourse
