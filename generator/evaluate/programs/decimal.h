// A decimal number exactly as it is printed: a double holds neither 0.1 nor 9007199254740993.
#pragma once

#include <string>
#include <string_view>

namespace mjcourse {

class Decimal {
 public:
  // `digits` with a point after the first `whole` of them, times ten to the power of `exponent`.
  Decimal(bool negative, std::string digits, int whole, int exponent);

  // The shortest one that reads as `value`, which is finite: what an author wrote, up to 15 digits.
  explicit Decimal(double value);

  // One at the last place of `other`: 0.01 for 1.25.
  static Decimal unit_of(const Decimal& other);

  // Do `a` and `b` differ by at most `most`, which is not negative?
  static bool within(const Decimal& a, const Decimal& b, const Decimal& most);

 private:
  // The digit that stands for ten to the power of `place`, with the number's sign.
  int at(int place) const;
  int last() const { return first_ - static_cast<int>(digits_.size()) + 1; }
  // Is a - b greater than `most`?
  static bool exceeds(const Decimal& a, const Decimal& b, const Decimal& most);

  bool negative_;
  std::string digits_;
  int first_;  // what power of ten the first digit stands for
};

}  // namespace mjcourse
