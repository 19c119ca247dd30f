// LocatedText: text taken out of a lesson that remembers where each of its bytes stood.
//
// A fence's body loses its indentation and its `> `, a JSON string loses its escapes; scripts,
// formulas and programs found inside are still blamed at the right column of the lesson.
// Tested by tests/generator/lesson/json/json_value_test.cpp.
#pragma once

#include <cstddef>
#include <string>

#include "base/source_text.h"
#include "lesson/syntax/offsets.h"

namespace mjcourse {

struct LocatedText {
  std::string text;
  // offsets[i] is where byte i of `text` stands in the lesson; one more for the end. Empty for
  // text that stands nowhere.
  Offsets offsets;

  // The place in the lesson of bytes [begin, end) of `text`.
  Span span(std::size_t begin, std::size_t end) const {
    if (offsets.empty()) return {};
    const std::size_t last = offsets.size() - 1;
    return {offsets[begin < last ? begin : last], offsets[end < last ? end : last]};
  }
  Span span() const { return span(0, text.size()); }

  // Bytes [begin, end) of `text`, where they stood.
  LocatedText part(std::size_t begin, std::size_t end) const;

  // The place of `line` and `column` (from 1, in characters) of `text`, `width` characters wide.
  Span span_at(int line, int column, int width) const;

  // Add `more`, which stands somewhere else, on a line of its own.
  void append_line(const LocatedText& more);
};

// Bytes [span) of `source` as they stand.
LocatedText located(const SourceText& source, Span span);

}  // namespace mjcourse
