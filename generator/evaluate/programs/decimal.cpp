#include "evaluate/programs/decimal.h"

#include <algorithm>
#include <charconv>
#include <iterator>
#include <utility>

#include "base/utf8.h"

namespace mjcourse {

Decimal::Decimal(bool negative, std::string digits, int whole, int exponent)
    : negative_(negative), digits_(std::move(digits)), first_(whole - 1 + exponent) {}

Decimal::Decimal(double value) : negative_(value < 0) {
  char buffer[32];
  const auto written =
      std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::scientific);
  const std::string_view text(buffer, static_cast<std::size_t>(written.ptr - buffer));
  const std::size_t e = text.find('e');  // d.ddde±XX, or de±XX
  std::copy_if(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(e),
               std::back_inserter(digits_), is_digit);
  const std::string_view exponent = text.substr(e + (text[e + 1] == '+' ? 2 : 1));
  std::from_chars(exponent.data(), exponent.data() + exponent.size(), first_);
}

Decimal Decimal::unit_of(const Decimal& other) {
  return {false, "1", 1, other.last()};
}

int Decimal::at(int place) const {
  if (place > first_ || place < last()) return 0;
  const int digit = digits_[static_cast<std::size_t>(first_ - place)] - '0';
  return negative_ ? -digit : digit;
}

bool Decimal::exceeds(const Decimal& a, const Decimal& b, const Decimal& most) {
  const int last = std::min({a.last(), b.last(), most.last()});
  int rest = 0;
  for (int place = std::max({a.first_, b.first_, most.first_}); place >= last; --place) {
    rest = 10 * rest + a.at(place) - b.at(place) - most.at(place);
    // Each place behind adds 27 at most: together less than 3 of this one.
    if (rest > 3 || rest < -3) return rest > 0;
  }
  return rest > 0;
}

bool Decimal::within(const Decimal& a, const Decimal& b, const Decimal& most) {
  return !exceeds(a, b, most) && !exceeds(b, a, most);
}

}  // namespace mjcourse
