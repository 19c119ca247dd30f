#include "remote/action_result.h"

#include <cstdint>
#include <utility>

namespace mjcourse {
namespace {

// Of ActionResult, stdout_raw and stderr_raw.
constexpr std::uint64_t kOutput = 5, kError = 7;

// How the length of a field is known.
enum Wire : std::uint64_t { kVarint = 0, k64Bits = 1, kBytes = 2, k32Bits = 5 };

void add_varint(std::string& to, std::uint64_t value) {
  for (; value >= 0x80; value >>= 7) to += static_cast<char>(value | 0x80);
  to += static_cast<char>(value);
}

void add_bytes(std::string& to, std::uint64_t field, std::string_view bytes) {
  add_varint(to, field << 3 | kBytes);
  add_varint(to, bytes.size());
  to.append(bytes);
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

std::string action_result(std::string_view output, std::string_view error) {
  std::string bytes;
  add_bytes(bytes, kOutput, output);
  if (!error.empty()) add_bytes(bytes, kError, error);
  return bytes;
}

std::optional<Outputs> outputs_of(std::string_view action_result) {
  Outputs found;
  bool has_output = false;
  while (!action_result.empty()) {
    const auto tag = take_varint(action_result);
    const auto size = tag ? take_size(*tag & 7, action_result) : std::nullopt;
    if (!size || *size > action_result.size()) return std::nullopt;
    if (*tag == (kOutput << 3 | kBytes)) {
      found.output = action_result.substr(0, *size);
      has_output = true;
    }
    if (*tag == (kError << 3 | kBytes)) found.error = action_result.substr(0, *size);
    action_result.remove_prefix(*size);
  }
  return has_output ? std::optional(std::move(found)) : std::nullopt;
}

}  // namespace mjcourse
