// The fences of a lesson as they stand in its text, also in one that is being typed, which no
// reader of the lesson language would take.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "base/source_text.h"

namespace mjcourse {

struct LessonFence {
  Span opening;  // its first line, from the marks on
  std::string info;
  Span body;
  std::size_t end = 0;  // of its last line

  // The first word of the info string: "lab".
  std::string kind() const;
  bool has(std::size_t offset) const { return opening.begin <= offset && offset <= end; }
};

// In their order; those in a demo follow it. A fence that is not closed goes on to the end.
std::vector<LessonFence> fences_of(const SourceText& text);

// The innermost around `offset`; null where there is none.
const LessonFence* fence_at(const std::vector<LessonFence>& fences, std::size_t offset);

// `span` of the text without what begins the lines of a quote: `> `.
std::string unquoted(const SourceText& text, Span span);

}  // namespace mjcourse
