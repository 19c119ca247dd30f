// A short name for a content, for addresses that may be cached for ever: FNV-1a, 64 bits.
#pragma once

#include <string>
#include <string_view>

namespace mjcourse {

// Ten characters of 0-9 and a-z, the same for the same content. Not against forgers.
std::string content_hash(std::string_view content);

}  // namespace mjcourse
