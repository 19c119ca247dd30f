// The glossary's page: every term in alphabetical order, what it means, and where it is used.
#pragma once

#include <map>
#include <string>

#include "findings/evaluation.h"
#include "page/blocks/page_writer.h"

namespace mjcourse {

// The page's body; `context` is that of glossary.html. `collation` is the text of
// script/collate.js.
std::string glossary_page(const Course& course, const Evaluation& evaluation,
                          const PageContext& context, const std::string& collation);

// What each term means as plain text, by its key; empty without a glossary.
std::map<std::string, std::string> plain_definitions(const Course& course,
                                                     const Evaluation& evaluation);

}  // namespace mjcourse
