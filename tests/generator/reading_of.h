// Reads lessons from text in memory, and shows their mistakes as a terminal would.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "lesson/read_lesson.h"
#include "report/terminal.h"

namespace mjcourse {

inline constexpr const char* kLessonPath = "content/1-a/1.1-x.md";

// What a terminal shows of `diagnostics`.
inline std::string shown(const Diagnostics& diagnostics) {
  std::string text;
  for (const Diagnostic& diagnostic : diagnostics) text += format_for_terminal(diagnostic);
  return text;
}

struct ReadingOf {
  std::optional<Lesson> lesson;
  Diagnostics diagnostics;

  std::string mistakes() const { return shown(diagnostics); }

  // The blocks of type T, in document order.
  template <typename T>
  std::vector<const T*> all() const {
    std::vector<const T*> found;
    for (const Block& block : lesson.value().blocks) {
      if (const auto* one = std::get_if<T>(&block)) found.push_back(one);
    }
    return found;
  }

  // The only block of type T.
  template <typename T>
  const T& only() const {
    const std::vector<const T*> found = all<T>();
    if (found.size() != 1) {
      throw std::runtime_error(std::to_string(found.size()) + " blocks, not one\n" + mistakes());
    }
    return *found[0];
  }

  // "line:column" of byte `at` of a text found in the lesson.
  std::string place(const LocatedText& text, std::size_t at = 0) const {
    return place(text.span(at, at + 1));
  }
  std::string place(Span span) const {
    const Position position = lesson.value().source->position(span.begin);
    return std::to_string(position.line) + ":" + std::to_string(position.column);
  }
};

// The file `bytes`, front matter and all.
inline ReadingOf reading_of_file(const std::string& bytes, const std::string& path = kLessonPath) {
  ReadingOf reading;
  reading.lesson = read_lesson(path, bytes, reading.diagnostics);
  return reading;
}

// A lesson with this body, which begins in line 4.
inline ReadingOf reading_of(const std::string& body) {
  return reading_of_file("---\ntitle: T\n---\n" + body);
}

inline std::string mistakes_in(const std::string& body) {
  return reading_of(body).mistakes();
}

// Each mistake: id, what it underlines, message, cure.
inline std::string underlined_mistakes(const ReadingOf& reading) {
  std::string text;
  for (const Diagnostic& d : reading.diagnostics) {
    const auto column = static_cast<std::size_t>(d.place.column - 1);
    text += d.id + " <" + d.place.excerpt.substr(column, static_cast<std::size_t>(d.place.width)) +
            "> " + d.message + (d.cure.empty() ? "" : " | " + d.cure) + "\n";
  }
  return text;
}

}  // namespace mjcourse
