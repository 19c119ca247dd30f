#include "base/origin.h"

#include <algorithm>
#include <utility>

namespace mjcourse {
namespace {

constexpr std::string_view kMade = "made", kUnsigned = "unsigned";
constexpr std::size_t kKeyDigits = 64;

bool is_key(std::string_view text) {
  return text.size() == kKeyDigits && text.find_first_not_of("0123456789abcdef") == text.npos;
}

}  // namespace

Origin Origin::unsigned_one() {
  Origin origin;
  origin.unsigned_ = true;
  return origin;
}

Origin Origin::signed_by(std::string public_key) {
  Origin origin;
  origin.keys_.insert(std::move(public_key));
  return origin;
}

void Origin::add(const Origin& other) {
  unsigned_ = unsigned_ || other.unsigned_;
  keys_.insert(other.keys_.begin(), other.keys_.end());
  if (unsigned_) keys_.clear();  // they vouch for a part of it
}

std::string Origin::text() const {
  if (unsigned_) return std::string(kUnsigned);
  std::string text;
  for (const std::string& key : keys_) text += (text.empty() ? "" : ",") + key;
  return text.empty() ? std::string(kMade) : text;
}

std::optional<Origin> Origin::read(std::string_view text) {
  if (text == kMade) return Origin();
  if (text == kUnsigned) return unsigned_one();
  Origin origin;
  for (std::size_t i = 0; i <= text.size();) {
    const std::size_t end = std::min(text.find(',', i), text.size());
    if (!is_key(text.substr(i, end - i))) return std::nullopt;
    origin.keys_.emplace(text.substr(i, end - i));
    i = end + 1;
  }
  return origin;
}

bool Trust::vouches_for(const Origin& origin) const {
  return !origin.unsigned_ && std::ranges::includes(keys, origin.keys_);
}

}  // namespace mjcourse
