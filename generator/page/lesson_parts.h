// What one lesson gives to the pages that list all of them.
//
// The home page and the page of what was verified grow with the course; their parts are made with
// each lesson's own page, on the same thread, and wait in a Spool.
#pragma once

#include "base/spool.h"
#include "page/page_writer.h"
#include "page/verification.h"

namespace mjcourse {

struct LessonParts {
  Spool::Piece card;                          // HTML, of the home page
  Spool::Piece json;                          // of verification.json
  Spool::Piece asserted, unchecked, section;  // HTML, of the page of what was verified
  StatusCounts counts{};                      // of its claims
};

// The card of `lesson`, which `writer` writes for the home page.
std::string home_card(const Lesson& lesson, const LessonResults& results, bool beside,
                      const PageWriter& writer, Templates& templates);

// All but the card.
LessonParts verification_parts(const Lesson& lesson, const Claims& claims, Templates& templates,
                               Spool& spool);

}  // namespace mjcourse
