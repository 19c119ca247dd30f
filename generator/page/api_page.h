// The page of MuJoCo's names: what each is that the course links to, and who speaks of it.
#pragma once

#include <string>

#include "findings/evaluation.h"
#include "page/blocks/page_writer.h"

namespace mjcourse {

// The page's body; `press` writes api.html.
std::string api_page(const Course& course, const Evaluation& evaluation, const Press& press);

}  // namespace mjcourse
