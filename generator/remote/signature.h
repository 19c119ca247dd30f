// Ed25519 signatures (RFC 8032) of what a shared store gives: whose word it is.
//
// A store that many may write into can hold an answer that somebody made up. Its hash is then right
// and its question, too. So a machine can sign what it puts, and another can take nothing but what
// one of the keys that it lists has signed.
// Tested by tests/generator/remote/signature_test.cpp.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

namespace mjcourse {

class SigningKey {
 public:
  // A new one, of the kernel's random numbers. Throws std::system_error.
  static SigningKey random();
  // That `file()` was written into; what is wrong with the file.
  static tl::expected<SigningKey, std::string> read(const std::filesystem::path& path);

  // What a file of it holds. It is a secret.
  std::string file() const;
  // 64 hexadecimal digits.
  std::string public_key() const;
  // Of `text`: 128 hexadecimal digits.
  std::string signature(std::string_view text) const;

 private:
  explicit SigningKey(std::string seed) : seed_(std::move(seed)) {}

  std::string seed_;  // 32 bytes
};

bool is_public_key(std::string_view digits);

// Did the owner of the public key sign `text`?
bool has_signed(std::string_view public_key, std::string_view text, std::string_view signature);

}  // namespace mjcourse
