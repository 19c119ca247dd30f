#include "page/kept_together.h"

#include <algorithm>
#include <array>

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

}  // namespace

std::size_t kept_length(std::string_view text) {
  std::size_t length = 0;
  while (const std::size_t more = unit_length(text.substr(length))) length += more;
  const std::size_t end = text.find_first_not_of(kPunctuation, length);
  return std::min(end, text.size());
}

}  // namespace mjcourse
