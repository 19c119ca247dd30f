#include "base/code_points.h"

#include <algorithm>

namespace mjcourse {

std::size_t sequence_length(std::string_view text) {
  const auto first = static_cast<std::uint8_t>(text[0]);
  if (first < 0x80) return 1;
  const std::size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC2 || first > 0xF4 || text.size() < length) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if (!is_continuation(text[i])) return 0;
  }
  const auto second = static_cast<std::uint8_t>(text[1]);
  const bool overlong = (first == 0xE0 && second < 0xA0) || (first == 0xF0 && second < 0x90);
  const bool surrogate = first == 0xED && second >= 0xA0;
  const bool too_large = first == 0xF4 && second >= 0x90;
  return overlong || surrogate || too_large ? 0 : length;
}

std::uint32_t code_point(std::string_view sequence) {
  constexpr std::uint32_t first_bits[] = {0, 0x7F, 0x1F, 0x0F, 0x07};  // by the length
  std::uint32_t point = static_cast<std::uint8_t>(sequence[0]) & first_bits[sequence.size()];
  for (const char c : sequence.substr(1)) {
    point = point << 6 | (static_cast<std::uint8_t>(c) & 0x3F);
  }
  return point;
}

std::u32string code_points(std::string_view text) {
  std::u32string points;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = sequence_length(text.substr(at));
    points += length == 0 ? U'\uFFFD' : static_cast<char32_t>(code_point(text.substr(at, length)));
    at += std::max<std::size_t>(1, length);
  }
  return points;
}

}  // namespace mjcourse
