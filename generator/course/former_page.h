// The addresses that lessons' pages had before they were renamed: `formerly` in the front matter.
//
// Each is the name of a file in the lesson's own folder, "1.2-old-name", or a path below the site's
// root, "1-old/1.2-old-name"; ".html" may stand behind either.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "course/course.h"
#include "course/link_target.h"

namespace mjcourse {

// The page below the site's root that `lesson` calls `written`, as "1-state/1.2-old-name.html";
// nothing where that is no page's address.
std::optional<std::string> former_page(const Lesson& lesson, const std::string& written);

// Which page was where: finds former addresses that lead nowhere, or to two places.
class FormerPages {
 public:
  explicit FormerPages(const Course& course);

  // What is wrong with entry `index` of the lesson's; a diagnostic without a place.
  std::optional<DeadLink> fault(const Lesson& lesson, std::size_t index) const;

 private:
  struct Claim {
    const Lesson* lesson;
    std::size_t index;
  };
  const Course& course_;
  std::map<std::string, const Lesson*> lessons_;  // by their pages
  std::map<std::string, Claim> claims_;           // the first of each
};

}  // namespace mjcourse
