// What one lesson gives to the pages that list all of them.
//
// The home page and the page of what was verified grow with the course; their parts are made with
// each lesson's own page, on the same thread, and wait in a Spool.
#pragma once

#include <optional>

#include "base/spool.h"
#include "page/blocks/page_writer.h"
#include "page/html/lesson_pictures.h"
#include "page/html/verification.h"

namespace mjcourse {

struct LessonParts {
  Spool::Piece card;                          // HTML, of the home page
  Spool::Piece progress;                      // HTML, a row of the reader's progress
  Spool::Piece review;                        // JSON, its questions; empty without
  Spool::Piece json;                          // of verification.json
  Spool::Piece asserted, unchecked, section;  // HTML, of the page of what was verified
  StatusCounts counts{};                      // of its claims
  Spool::Piece printed, printed_answers;      // HTML, of print.html; the answers may be empty
  Spool::Piece search;                        // JSON, of the search's index (search_index.h)
  std::string search_hash;                    // of that
  Spool::Piece news;                          // XML, of the feed; empty where it is not in there
  std::optional<SharedPicture> picture{};     // of the home page, where it is the first
};

// On the home page: the first of all, another one of the course, or of what stands beside it,
// without a picture.
enum class CardPlace { first, within, beside };

// The card of `lesson`, which `writer` writes for the home page.
std::string home_card(const Lesson& lesson, const LessonResults& results, CardPlace place,
                      const PageWriter& writer, Templates& templates);

// What a lesson asks of its reader, as PageWriter gives it.
struct AskedOfReader {
  nlohmann::json questions = nlohmann::json::array();
  nlohmann::json exercises = nlohmann::json::array();
};

// The row of `lesson` in the table of a reader's progress.
std::string progress_row(const Lesson& lesson, const AskedOfReader& asked, Templates& templates);

// What the review page has of `lesson` (page/learner_pages.h); "" where nothing is asked.
std::string review_json(const Lesson& lesson, const AskedOfReader& asked, Templates& templates);

// What the page of what was verified has of it.
LessonParts verification_parts(const Lesson& lesson, const Claims& claims, Templates& templates,
                               Spool& spool);

}  // namespace mjcourse
