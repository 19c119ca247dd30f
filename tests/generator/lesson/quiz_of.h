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
  std::string text;
  for (const Diagnostic& d : quiz_of(questions).diagnostics) {
    const auto column = static_cast<std::size_t>(d.place.column - 1);
    text += d.id + " <" + d.place.excerpt.substr(column, static_cast<std::size_t>(d.place.width)) +
            "> " + d.message + (d.cure.empty() ? "" : " | " + d.cure) + "\n";
  }
  return text;
}

}  // namespace mjcourse
