#include "base/percent_encoding.h"

#include <charconv>

#include "base/utf8.h"

namespace mjcourse {

bool is_unreserved(char c) {
  return is_letter_or_digit(c) || std::string_view("-._~").find(c) != std::string_view::npos;
}

std::string percent_encoded(std::string_view text, const std::function<bool(char)>& plain) {
  constexpr std::string_view digits = "0123456789ABCDEF";
  std::string encoded;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (plain(c)) {
      encoded += c;
    } else {
      encoded += {'%', digits[byte / 16], digits[byte % 16]};
    }
  }
  return encoded;
}

std::optional<char> encoded_byte(std::string_view text, std::size_t at) {
  const std::string_view encoded = text.substr(at, kEncodedByte);
  if (encoded.size() < kEncodedByte || encoded[0] != '%') return std::nullopt;
  unsigned char byte = 0;
  const char* const end = encoded.data() + encoded.size();
  if (std::from_chars(encoded.data() + 1, end, byte, 16).ptr != end) return std::nullopt;
  return static_cast<char>(byte);
}

}  // namespace mjcourse
