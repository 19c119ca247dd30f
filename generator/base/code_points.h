// UTF-8 as the code points it stands for. The engine in the browser has this too, and no more of
// UTF-8 (site/browser/engine/wasm/generator.txt).
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace mjcourse {

// Does this byte go on with a sequence that an earlier one began?
constexpr bool is_continuation(char c) {
  return (static_cast<unsigned char>(c) & 0xC0) == 0x80;
}

// The length of the well-formed sequence (RFC 3629) at the start of `text`, which is not empty, or
// 0.
std::size_t sequence_length(std::string_view text);

// Of one well-formed sequence.
std::uint32_t code_point(std::string_view sequence);

// All of `text`; U+FFFD for each byte that is not UTF-8.
std::u32string code_points(std::string_view text);

}  // namespace mjcourse
