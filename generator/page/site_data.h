// What all pages of a site are made of, and what the frame around a page says of it.
#pragma once

#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "base/files.h"
#include "course/course.h"
#include "course/last_changed.h"
#include "findings/evaluation.h"
#include "page/course_data.h"
#include "page/html/lesson_pictures.h"

namespace mjcourse {

// The claims of a lesson of which an outline was kept (lesson/unloaded_lesson.h), once reloaded.
using OutlineClaims = std::function<Claims(const Lesson&)>;

struct SiteData {
  const Course& course;
  const Evaluation& evaluation;
  const Files& files;                              // the course's
  const Files& assets;                             // what the site's build made
  nlohmann::json manifest;                         // the way from a plain name to a path
  std::map<std::string, std::string> definitions;  // of the glossary's terms
  bool places = false;                             // pages tell of which lines they are made
  std::string theme = {};                          // the course's own stylesheet; "" for none
  LastChanges changes = {};                        // of the lessons' files, as far as git knows
  bool asks = has_questions(course);               // some published lesson does
  bool feed = false;                               // it has one (page/web_files.h)
  OutlineClaims claims_of_outline = {};            // of lessons of which an outline is kept
  bool prints = true;                              // it has print.html (page/printed_course.h)
  std::size_t compiler_bytes = 0;                  // as PageContext has it
  bool solutions = true;                           // exercises are shown with theirs
};

// What the frame says of a page.
struct PageHead {
  std::string kind;  // "home", "lesson", "glossary" …
  std::string title;
  std::string description;
  std::string root = {};                      // the way from the page to the site's root: "../"
  const Lesson* current = nullptr;            // the lesson whose page it is
  std::optional<SharedPicture> picture = {};  // of the page, for those who show a link to it
  bool anywhere = false;                      // it is shown at any address, whatever its depth
};

}  // namespace mjcourse
