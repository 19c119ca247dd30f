// The page of MuJoCo's names: what each is that the course links to, and which lessons speak of it.
// Tested by tests/site/checks/references.mjs.
#pragma once

#include <string>

#include "findings/evaluation.h"
#include "page/blocks/page_writer.h"

namespace mjcourse {

// The page's body; `context` is that of api.html.
std::string api_page(const Course& course, const Evaluation& evaluation,
                     const PageContext& context);

}  // namespace mjcourse
