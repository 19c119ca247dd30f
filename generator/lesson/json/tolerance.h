// "tol": by how much a number may differ from the right one. What a reader gives is judged in the
// page by the same rule (site/browser/client/quiz/near.ts).
#pragma once

#include <cmath>
#include <vector>

namespace mjcourse {

class JsonObject;
class Reading;

struct Tolerance {
  double amount = 0;
  bool relative = false;  // then `amount` is a fraction of the right number

  double around(double right) const { return relative ? amount * std::abs(right) : amount; }
  // Is `value` near enough? Decimals are not exact in binary, so a little more is, but of whole
  // numbers only where the tolerance says so.
  bool allows(double value, double right) const;
};

// How far apart two of `values` are that only the rounding of doubles tells apart: nothing where
// all are whole numbers, which are held exactly below 2^53.
double rounding(const std::vector<double>& values);

// The value at "tol": a number, or a percentage of the right one such as "1%"; 0 without one.
Tolerance read_tolerance(JsonObject& object, Reading& reading);

}  // namespace mjcourse
