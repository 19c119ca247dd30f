// Do two runs of a program report the same to its lesson?
#pragma once

#include <string>
#include <vector>

#include "findings/result.h"

namespace mjcourse {

// The first record that differs, as "the result `x` is 3 there, and 2 natively"; "" where none
// does. Numbers may differ by a hundred-thousandth of themselves, more than a text quotes: each
// C library rounds its own way, and what a program fits or extrapolates enlarges that.
std::string record_diff(const Records& native, const Records& page);
// Of what they checked alone.
std::string check_diff(const std::vector<Check>& native, const std::vector<Check>& page);

}  // namespace mjcourse
