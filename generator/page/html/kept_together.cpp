#include "page/html/kept_together.h"

#include <algorithm>
#include <array>

#include "base/utf8.h"

namespace mjcourse {
namespace {

constexpr std::string_view kPunctuation = ".,;:!?)]%";
constexpr std::array<std::string_view, 26> kUnits{
    "m",  "mm", "cm", "km",  "s",  "ms", "min", "kg",    "g",   "N",    "mN",  "kN", "J",
    "mJ", "W",  "Hz", "kHz", "kB", "MB", "rad", "rad/s", "m/s", "mm/s", "N/m", "%",  "degrees"};

// Of a blank and a unit; 0 where there is none.
std::size_t unit_length(std::string_view text) {
  if (!text.starts_with(' ')) return 0;
  text.remove_prefix(1);
  const std::string_view word = text.substr(0, text.find_first_of(" \n.,;:!?)]"));
  const bool is_unit = std::ranges::find(kUnits, word) != kUnits.end();
  return is_unit ? 1 + word.size() : 0;
}

// The blank between the next number from `begin` on and its unit.
std::size_t next_unit(std::string_view text, std::size_t begin) {
  for (std::size_t i = text.find(' ', begin); i != std::string_view::npos;
       i = text.find(' ', i + 1)) {
    const bool ends_number = i > 0 && is_digit(text[i - 1]);
    if (ends_number && unit_length(text.substr(i)) > 0) return i;
  }
  return std::string_view::npos;
}

}  // namespace

std::size_t kept_length(std::string_view text) {
  std::size_t length = 0;
  while (const std::size_t more = unit_length(text.substr(length))) length += more;
  const std::size_t end = text.find_first_not_of(kPunctuation, length);
  return std::min(end, text.size());
}

bool has_units(std::string_view text) {
  return next_unit(text, 0) != std::string_view::npos;
}

std::string with_kept_units(std::string_view text) {
  std::string kept;
  std::size_t begin = 0;
  for (std::size_t blank; (blank = next_unit(text, begin)) != std::string_view::npos;) {
    kept += text.substr(begin, blank - begin);
    begin = blank;
    while (const std::size_t length = unit_length(text.substr(begin))) {
      kept.append("\u00a0").append(text.substr(begin + 1, length - 1));
      begin += length;
    }
  }
  return kept.append(text.substr(begin));
}

}  // namespace mjcourse
