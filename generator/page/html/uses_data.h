// The links back: which lessons and sections speak of what a reference page explains.
// Tested by tests/generator/page/glossary_page_test.cpp.
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "course/uses.h"
#include "findings/evaluation.h"

namespace mjcourse {

// As used-in.hbs wants it; `root` is the way from the page to the site's root.
nlohmann::json uses_data(const std::vector<Use>& uses, const Evaluation& evaluation,
                         const std::string& root);

}  // namespace mjcourse
