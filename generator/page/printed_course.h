// print.html: the whole course as one document, to be printed or kept as a PDF.
//
// Each lesson gives two pieces, made with its own page: its text, and what it asks the answers to.
// They wait in the Spool, so the document takes no memory, however long; but a browser has to set
// it as a whole, so a course with more lessons than `kMostPrinted` has none.
#pragma once

#include <cstddef>
#include <vector>

#include "page/lesson_page.h"
#include "page/lesson_parts.h"
#include "page/page_press.h"

namespace mjcourse {

inline constexpr const char* kPrintPage = "print.html";
inline constexpr std::size_t kMostPrinted = 500;

// Whether the site has that document.
bool has_print(const Course& course);

// What `lesson`, whose page is `page`, gives to it.
void add_printed_parts(const SiteData& site, const Lesson& lesson, const LessonPage& page,
                       const PageWriter& writer, Templates& templates, Spool& spool,
                       LessonParts& parts);

// `parts` are those of the lessons, by their index; `glossary` is the glossary's body, "" for none.
void write_printed_course(const SiteData& site, const std::vector<LessonParts>& parts,
                          const std::string& glossary, PagePress& press, Spool& spool,
                          SiteFiles& directory);

}  // namespace mjcourse
