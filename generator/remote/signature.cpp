#include "remote/signature.h"

#include <nettle/base16.h>
#include <nettle/eddsa.h>
#include <sys/random.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <optional>
#include <system_error>
#include <utility>

#include "base/files.h"

namespace mjcourse {
namespace {

constexpr std::string_view kMark = "mjcourse-signing-key ";
constexpr std::size_t kKeyDigits = BASE16_ENCODE_LENGTH(ED25519_KEY_SIZE);

using Key = std::array<std::uint8_t, ED25519_KEY_SIZE>;
using Signature = std::array<std::uint8_t, ED25519_SIGNATURE_SIZE>;

const std::uint8_t* as_bytes(std::string_view text) {
  return reinterpret_cast<const std::uint8_t*>(text.data());
}

template <typename Bytes>
std::string digits_of(const Bytes& bytes) {
  std::string digits(BASE16_ENCODE_LENGTH(bytes.size()), '\0');
  base16_encode_update(digits.data(), bytes.size(),
                       as_bytes({reinterpret_cast<const char*>(bytes.data()), bytes.size()}));
  return digits;
}

template <typename Bytes>
std::optional<Bytes> bytes_of(std::string_view digits) {
  Bytes bytes;
  if (digits.size() != BASE16_ENCODE_LENGTH(bytes.size()) ||
      digits.find_first_not_of("0123456789abcdef") != digits.npos) {
    return std::nullopt;
  }
  base16_decode_ctx state;
  base16_decode_init(&state);
  std::size_t size = bytes.size();
  base16_decode_update(&state, &size, bytes.data(), digits.size(), digits.data());
  return bytes;
}

Key public_of(const std::string& seed) {
  Key key;
  ed25519_sha512_public_key(key.data(), as_bytes(seed));
  return key;
}

}  // namespace

SigningKey SigningKey::random() {
  std::string seed(ED25519_KEY_SIZE, '\0');
  // Of so few bytes, all or none come.
  if (getrandom(seed.data(), seed.size(), 0) != static_cast<ssize_t>(seed.size())) {
    throw std::system_error(errno, std::generic_category(), "random numbers");
  }
  return SigningKey(std::move(seed));
}

tl::expected<SigningKey, std::string> SigningKey::read(const std::filesystem::path& path) {
  const auto text = read_file(path);
  if (!text) return tl::unexpected(path.string() + " cannot be read");
  std::string_view digits = *text;
  if (digits.starts_with(kMark)) digits.remove_prefix(kMark.size());
  const auto seed = bytes_of<Key>(digits.substr(0, digits.find_first_of("\r\n")));
  if (!seed || !text->starts_with(kMark)) {
    return tl::unexpected(path.string() + " is not a key that `mjcourse store key` made");
  }
  return SigningKey(std::string(seed->begin(), seed->end()));
}

std::string SigningKey::file() const {
  return std::string(kMark) + digits_of(seed_) + "\n";
}

std::string SigningKey::public_key() const {
  return digits_of(public_of(seed_));
}

std::string SigningKey::signature(std::string_view text) const {
  Signature signature;
  ed25519_sha512_sign(public_of(seed_).data(), as_bytes(seed_), text.size(), as_bytes(text),
                      signature.data());
  return digits_of(signature);
}

bool is_public_key(std::string_view digits) {
  return digits.size() == kKeyDigits && bytes_of<Key>(digits).has_value();
}

bool has_signed(std::string_view public_key, std::string_view text, std::string_view signature) {
  const auto key = bytes_of<Key>(public_key);
  const auto signed_by = bytes_of<Signature>(signature);
  return key && signed_by &&
         ed25519_sha512_verify(key->data(), text.size(), as_bytes(text), signed_by->data()) == 1;
}

}  // namespace mjcourse
