#include "cache/cbor.h"

#include <cstdint>
#include <nlohmann/json.hpp>
#include <vector>

#include "base/utf8.h"

namespace mjcourse {
namespace {

using nlohmann::json;

constexpr std::size_t kMostDepth = 100;  // of lists and objects; a result has about ten

// Goes through the heads of all items (RFC 8949) of what to_cbor() may have written. What becomes
// of it would be written as JSON, which wants UTF-8.
class Look {
 public:
  explicit Look(std::string_view bytes) : bytes_(bytes) {}

  bool is_sound() {
    open_ = {1};
    while (!open_.empty()) {
      if (open_.back()-- == 0) {
        open_.pop_back();
      } else if (!take_item()) {
        return false;
      }
    }
    return at_ == bytes_.size();
  }

 private:
  bool take_item() {
    if (at_ == bytes_.size()) return false;
    const auto head = static_cast<std::uint8_t>(bytes_[at_++]);
    const unsigned kind = head >> 5, form = head & 0x1F;
    std::uint64_t value = form;
    if (form > 27 || !take_value(form, value)) return false;
    const std::size_t left = bytes_.size() - at_;
    switch (kind) {
      case 0:
      case 1:
      case 7:
        return true;
      case 2:
      case 3:
        if (value > left) return false;
        at_ += value;
        return kind == 2 || !find_invalid_utf8(bytes_.substr(at_ - value, value));
      case 4:
      case 5:
        open_.push_back(kind == 4 ? value : 2 * value);
        return value <= left && open_.size() <= kMostDepth;
      default:
        return false;  // a tag
    }
  }

  // Of 1, 2, 4 or 8 bytes behind the head, where it does not hold the value itself.
  bool take_value(unsigned form, std::uint64_t& value) {
    if (form < 24) return true;
    const std::size_t size = std::size_t{1} << (form - 24);
    if (bytes_.size() - at_ < size) return false;
    value = 0;
    for (std::size_t i = 0; i < size; ++i) {
      value = value << 8 | static_cast<std::uint8_t>(bytes_[at_++]);
    }
    return true;
  }

  std::string_view bytes_;
  std::size_t at_ = 0;
  std::vector<std::uint64_t> open_;  // items that are still to come, of each list and object
};

}  // namespace

std::string to_cbor(const json& value) {
  std::string bytes;
  json::to_cbor(value, bytes);
  return bytes;
}

std::optional<json> from_cbor(std::string_view bytes) {
  if (!Look(bytes).is_sound()) return std::nullopt;
  try {
    return json::from_cbor(bytes);
  } catch (const json::exception&) {
    return std::nullopt;
  }
}

}  // namespace mjcourse
