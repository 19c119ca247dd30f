#include "evaluate/programs/decimal.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <utility>

#include "base/utf8.h"

namespace mjcourse {

Decimal::Decimal(bool negative, std::string digits, int whole, int exponent)
    : negative_(negative), digits_(std::move(digits)), first_(whole - 1 + exponent) {}

// Not by to_chars, which the standard library of the page's engine does not have for a double.
Decimal::Decimal(double value) : negative_(value < 0) {
  char text[32];  // d.ddde±XX
  for (int digits = 0; digits < 17; ++digits) {
    std::snprintf(text, sizeof text, "%.*e", digits, std::abs(value));
    if (std::strtod(text, nullptr) == std::abs(value)) break;
  }
  const std::string_view written(text), significand = written.substr(0, written.find('e'));
  std::copy_if(significand.begin(), significand.end(), std::back_inserter(digits_), is_digit);
  const std::string_view exponent = written.substr(significand.size() + 1);
  const std::size_t sign = exponent.starts_with('+') ? 1 : 0;
  std::from_chars(exponent.data() + sign, exponent.data() + exponent.size(), first_);
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
