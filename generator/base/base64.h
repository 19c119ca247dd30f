// Bytes as text that JSON takes.
#pragma once

#include <string>
#include <string_view>

namespace mjcourse {

// RFC 4648, with `=` at the end.
std::string base64(std::string_view bytes);

}  // namespace mjcourse
