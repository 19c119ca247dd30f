// SHA-256, in hexadecimal digits: the address of bytes, and of what a result was made from.
#pragma once

#include <nettle/sha2.h>

#include <string>
#include <string_view>

namespace mjcourse {

class Sha256 {
 public:
  Sha256() { sha256_init(&state_); }

  // A part with its length, so that no two lists of parts run together.
  Sha256& add(std::string_view part);
  Sha256& add_raw(std::string_view bytes);
  // 64 digits. Once.
  std::string hex();

 private:
  sha256_ctx state_;
};

std::string sha256(std::string_view bytes);

}  // namespace mjcourse
