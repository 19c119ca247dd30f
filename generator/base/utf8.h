// UTF-8: what the lesson language is written in.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace mjcourse {

// Unicode code points in `text`, which is valid UTF-8.
int count_characters(std::string_view text);

// The offset of the first byte that is not well-formed UTF-8 (RFC 3629: no overlong forms, no
// surrogates, nothing past U+10FFFF), or nothing when all of `text` is.
std::optional<std::size_t> find_invalid_utf8(std::string_view text);

// `text`, which is valid UTF-8, in small letters: what matches whatever its case.
std::string lower_case_utf8(std::string_view text);

}  // namespace mjcourse
