#include "report/refused_file.h"

#include <utility>

namespace mjcourse {

Diagnostic refused_file(Place place, const std::string& path, const std::string& why) {
  return error_at(
      std::move(place), "E-file-refused", path + " " + why,
      "a course is made of its own files: put a copy there, or a link that stays inside "
      "of the course");
}

}  // namespace mjcourse
