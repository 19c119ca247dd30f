// TextPoint: a place in a text as editors count: lines from 0, and in a line the units of an
// encoding: UTF-16's, unless both sides know UTF-8. We count bytes, and in messages characters.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string_view>

#include "base/source_text.h"

namespace mjcourse {

enum class Units { utf16, utf8 };

struct TextPoint {
  int line = 0;
  int unit = 0;
};

struct TextRange {
  TextPoint begin, end;
};

// How many units `text` has, which is valid UTF-8.
int count_units(std::string_view text, Units units);

// The byte at `point`. What is past a line's end is its end, and what is past the last line the
// text's; a point inside of a character is its beginning.
std::size_t offset_of(const SourceText& text, TextPoint point, Units units);

TextPoint point_of(const SourceText& text, std::size_t offset, Units units);
TextRange range_of(const SourceText& text, Span span, Units units);

// As the protocol has them. Reading throws nlohmann's exceptions, and takes what is less than 0 for
// 0.
TextPoint read_point(const nlohmann::json& point);
TextRange read_range(const nlohmann::json& range);
nlohmann::json json_of(const TextRange& range);

}  // namespace mjcourse
