#include "page/html/fixed_number.h"

#include <cstdio>

namespace mjcourse {

std::string fixed_number(double value, int digits) {
  char text[400];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  const bool zero = std::string(text).find_first_of("123456789") == std::string::npos;
  return zero && text[0] == '-' ? text + 1 : text;
}

}  // namespace mjcourse
