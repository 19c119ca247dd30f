#include "remote/action_result.h"

#include <cstdint>

namespace mjcourse {
namespace {

// Of ActionResult, stdout_raw.
constexpr std::uint64_t kOutput = 5;

// How the length of a field is known.
enum Wire : std::uint64_t { kVarint = 0, k64Bits = 1, kBytes = 2, k32Bits = 5 };

void add_varint(std::string& to, std::uint64_t value) {
  for (; value >= 0x80; value >>= 7) to += static_cast<char>(value | 0x80);
  to += static_cast<char>(value);
}

// Takes it off the front.
std::optional<std::uint64_t> take_varint(std::string_view& from) {
  std::uint64_t value = 0;
  for (int shift = 0; shift < 64 && !from.empty(); shift += 7) {
    const auto byte = static_cast<unsigned char>(from.front());
    from.remove_prefix(1);
    value |= std::uint64_t{byte & 0x7fu} << shift;
    if (byte < 0x80) return value;
  }
  return std::nullopt;
}

// How many bytes a field's value has, of which those of a length are taken off.
std::optional<std::uint64_t> take_size(std::uint64_t wire, std::string_view& from) {
  switch (wire) {
    case kVarint: {
      std::string_view rest = from;
      if (!take_varint(rest)) return std::nullopt;
      return from.size() - rest.size();
    }
    case k64Bits:
      return 8;
    case kBytes:
      return take_varint(from);
    case k32Bits:
      return 4;
    default:
      return std::nullopt;
  }
}

}  // namespace

std::string action_result(std::string_view output) {
  std::string bytes;
  add_varint(bytes, kOutput << 3 | kBytes);
  add_varint(bytes, output.size());
  return bytes.append(output);
}

std::optional<std::string> output_of(std::string_view action_result) {
  std::optional<std::string> output;
  while (!action_result.empty()) {
    const auto tag = take_varint(action_result);
    const auto size = tag ? take_size(*tag & 7, action_result) : std::nullopt;
    if (!size || *size > action_result.size()) return std::nullopt;
    if (*tag == (kOutput << 3 | kBytes)) output = action_result.substr(0, *size);
    action_result.remove_prefix(*size);
  }
  return output;
}

}  // namespace mjcourse
