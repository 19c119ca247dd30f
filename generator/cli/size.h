// Sizes as people write them: 500MB, 2GB, 1.5GB; a thousand thousand bytes are one MB.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace mjcourse {

// Nothing where `text` is no size.
std::optional<std::uintmax_t> read_size(const std::string& text);

// "1.4 GB", "312 kB", "17 bytes"
std::string size_text(std::uintmax_t bytes);

}  // namespace mjcourse
