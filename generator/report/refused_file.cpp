#include "report/refused_file.h"

#include <utility>

namespace mjcourse {

Diagnostic refused_file(Place place, const std::string& path, const FileRefusal& refusal) {
  return error_at(std::move(place), "E-file-refused", path + " " + refusal.why, refusal.cure);
}

}  // namespace mjcourse
