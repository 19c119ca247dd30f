// "tol": by how much a number may differ from the right one.
#pragma once

#include <cmath>

namespace mjcourse {

class JsonObject;
class Reading;

struct Tolerance {
  double amount = 0;
  bool relative = false;  // then `amount` is a fraction of the right number

  double around(double right) const { return relative ? amount * std::abs(right) : amount; }
};

// The value at "tol": a number, or a percentage of the right one such as "1%"; 0 without one.
Tolerance read_tolerance(JsonObject& object, Reading& reading);

}  // namespace mjcourse
