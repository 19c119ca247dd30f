// Reads a quiz from the JSON of its questions, and shows its mistakes in short.
#pragma once

#include <string>

#include "reading_of.h"

namespace mjcourse {

inline ReadingOf quiz_of(const std::string& questions) {
  return reading_of("```quiz\n{\"id\": \"q\", \"questions\": [" + questions + "]}\n```\n");
}

// Each mistake in the questions: id, what it underlines, message, cure.
inline std::string quiz_mistakes(const std::string& questions) {
  return underlined_mistakes(quiz_of(questions));
}

}  // namespace mjcourse
