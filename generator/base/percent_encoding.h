// Percent-encoding (RFC 3986): "a b" is "a%20b". Which bytes stay as they are differs from one part
// of an address to the next, so it is asked.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace mjcourse {

// May `c` stand anywhere in an address as it is: a letter or digit of ASCII, one of `-._~`?
bool is_unreserved(char c);

// `text` with each byte that is not `plain` as a percent sign and its number: "%0A".
std::string percent_encoded(std::string_view text, const std::function<bool(char)>& plain);

// How long an encoded byte is: "%20".
inline constexpr std::size_t kEncodedByte = 3;

// The byte whose number stands at `at`, behind a percent sign; nothing where there is none.
std::optional<char> encoded_byte(std::string_view text, std::size_t at);

}  // namespace mjcourse
