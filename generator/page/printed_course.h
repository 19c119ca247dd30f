// print.html: the whole course as one document, to be printed or kept as a PDF.
//
// Each lesson gives two pieces, made with its own page: its text, and what it asks the answers to.
// They wait in the Spool, so the document takes no memory, however long. But a browser has to set
// it as a whole, so a course of which it would have more than `kMostPrinted` bytes has none.
#pragma once

#include <atomic>
#include <cstddef>
#include <vector>

#include "page/lesson_page.h"
#include "page/lesson_parts.h"
#include "page/page_renderer.h"
#include "page/site_data.h"

namespace mjcourse {

inline constexpr std::size_t kMostPrinted = 8 << 20;

// How long the document is so far. Lessons add to it on several threads and in any order; once it
// is too long, whichever come later need not.
class PrintedLength {
 public:
  // A course whose own text is too long has no document from the start.
  explicit PrintedLength(const Course& course);

  bool fits() const { return bytes_ <= kMostPrinted; }
  void add(const LessonParts& parts) { bytes_ += parts.printed.size + parts.printed_answers.size; }

 private:
  std::atomic<std::size_t> bytes_ = 0;
};

// What `lesson`, whose page is `page`, gives to it.
void add_printed_parts(const SiteData& site, const Lesson& lesson, const LessonPage& page,
                       const PageWriter& writer, Templates& templates, Spool& spool,
                       LessonParts& parts);

// `parts` are those of the lessons, by their index; `glossary` is the glossary's body, "" for none.
void write_printed_course(const SiteData& site, const std::vector<LessonParts>& parts,
                          const std::string& glossary, PageRenderer& renderer, Spool& spool,
                          SiteFiles& directory);

}  // namespace mjcourse
