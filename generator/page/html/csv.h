// Tables to download: comma-separated values, as RFC 4180 has them.
#pragma once

#include <string>
#include <vector>

#include "findings/result.h"

namespace mjcourse {

// A line of names, then one for each row; numbers with as many digits as tell them from all others.
std::string csv_of(const Table& table);

// One field of it.
std::string csv_field(const std::string& text);

}  // namespace mjcourse
