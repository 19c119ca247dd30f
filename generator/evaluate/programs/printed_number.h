// A number in what a program printed, and when two of them agree.
//
// Only what is a number by itself is one, perhaps with its unit behind it: 0.25, -3e-7, 0.5m.
// Digits in a version, an address, a hash, a name, a date or a time are text: 2.2.2, 0x1e5, l1_2,
// 12:30.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

#include "evaluate/programs/decimal.h"

namespace mjcourse {

class PrintedNumber {
 public:
  // The number that begins at byte `at` of `line`; nothing where none does.
  static std::optional<PrintedNumber> find(std::string_view line, std::size_t at);

  std::size_t length() const { return length_; }

  // Does `real` agree with this number of a lesson? It may differ by one unit of the last place
  // that the lesson prints, or by `tolerance`, where there is one.
  bool agrees_with(const PrintedNumber& real, const std::optional<Decimal>& tolerance) const;

 private:
  static std::optional<PrintedNumber> read(std::string_view text);

  bool shows_place() const;
  bool is_zero() const;
  Decimal value() const;

  bool negative_ = false;
  std::string_view whole_, fraction_, exponent_;  // the digits, and what stands behind the e
  std::size_t length_ = 0;
};

}  // namespace mjcourse
