// PagePress: what one thread writes the pages of a site with.
//
// Enter with write(), which puts a body into the frame that all pages have. Script engines serve
// one thread each, so every thread that writes pages has a press of its own; what they share
// (SiteData) they only read.
#pragma once

#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "base/spool.h"
#include "course/course.h"
#include "course/last_changed.h"
#include "findings/evaluation.h"
#include "page/course_data.h"
#include "page/lesson_pictures.h"
#include "page/page_writer.h"
#include "page/site_files.h"

namespace mjcourse {

// The claims of a lesson that rested as a card (lesson/resting_lesson.h) and was woken.
using CardClaims = std::function<Claims(const Lesson&)>;

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
  CardClaims claims_of_card = {};                  // of lessons that rest as cards
  bool prints = true;                              // it has print.html (page/printed_course.h)
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

// Pieces of a body, which has a mark in their place.
struct PagePart {
  std::string mark;
  std::vector<Spool::Piece> pieces;
};

// The script engines of a press, which serve any number of sites one after the other.
struct PressEngines {
  // Who writes the same pages again and again gives more memory, in bytes for each.
  explicit PressEngines(const Files& assets, std::size_t memory = kLittleMemory);
  Templates templates;
  Highlighter highlighter;
};

class PagePress {
 public:
  // All must outlive this.
  PagePress(const SiteData& site, SiteFiles& directory, PressEngines& engines)
      : site_(site), directory_(directory), engines_(engines) {}

  // For the page `path`, which needs `styles`.
  Press press(InlineStyles& styles, const std::string& path);
  Templates& templates() { return engines_.templates; }

  // Write the page `path` with its stylesheet, if it needs one.
  void write(const std::string& path, const PageHead& head, const std::string& body,
             InlineStyles& styles);

  // The same of a body whose parts, in their order, wait in a spool.
  void write_long(const std::string& path, const PageHead& head, const std::string& body,
                  const std::vector<PagePart>& parts, Spool& spool);

 private:
  std::string frame(const std::string& path, const PageHead& head, const std::string& body,
                    const InlineStyles& styles);

  const SiteData& site_;
  SiteFiles& directory_;
  PressEngines& engines_;
};

}  // namespace mjcourse
