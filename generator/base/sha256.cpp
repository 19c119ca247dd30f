#include "base/sha256.h"

#include <array>
#include <cstdint>

namespace mjcourse {

Sha256& Sha256::add(std::string_view part) {
  return add_raw(std::to_string(part.size()) + ":").add_raw(part);
}

Sha256& Sha256::add_raw(std::string_view bytes) {
  sha256_update(&state_, bytes.size(), reinterpret_cast<const std::uint8_t*>(bytes.data()));
  return *this;
}

std::string Sha256::hex() {
  std::array<std::uint8_t, SHA256_DIGEST_SIZE> digest{};
  sha256_digest(&state_, digest.size(), digest.data());
  std::string text;
  for (const unsigned byte : digest) {
    text += "0123456789abcdef"[byte >> 4];
    text += "0123456789abcdef"[byte & 15];
  }
  return text;
}

std::string sha256(std::string_view bytes) {
  return Sha256().add_raw(bytes).hex();
}

}  // namespace mjcourse
