// Reads the JSON of a lab, and tells its mistakes in a line each.
#pragma once

#include <string>

#include "reading_of.h"

namespace mjcourse {

// The JSON begins in line 5.
inline ReadingOf lab_reading(const std::string& json) {
  return reading_of("```lab simlab\n" + json + "\n```\n");
}

// A lab with `members` beside what each must have.
inline ReadingOf lab_with(const std::string& members) {
  return lab_reading(R"({"title": "T", "model": "m", "alt": "A.", )" + members + "}");
}

// Each mistake of such a lab: id, what it underlines, message, cure.
inline std::string lab_mistakes(const std::string& members) {
  return underlined_mistakes(lab_with(members));
}

}  // namespace mjcourse
