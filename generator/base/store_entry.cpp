#include "base/store_entry.h"

#include <algorithm>
#include <array>

#include "base/sha256.h"

namespace mjcourse {
namespace {

constexpr std::string_view kAnyMark = "mjcourse-store ", kMark = "mjcourse-store 2 ";
constexpr std::array<std::string_view, 4> kKinds{"ac/", "cas/", "list/", "here/"};
constexpr std::size_t kDigits = 64;

std::string hash_of_entry(const std::string& name, std::string_view bytes) {
  return Sha256().add(name).add(bytes).hex();
}

bool has_own_hash(const std::string& name) {
  return name.starts_with("cas/");
}

}  // namespace

bool is_store_name(std::string_view name) {
  const auto* kind =
      std::ranges::find_if(kKinds, [&](std::string_view one) { return name.starts_with(one); });
  if (kind == kKinds.end()) return false;
  const std::string_view hash = name.substr(kind->size());
  return hash.size() == kDigits && hash.find_first_not_of("0123456789abcdef") == hash.npos;
}

std::string sealed(const std::string& name, std::string_view bytes) {
  if (has_own_hash(name)) return std::string(bytes);
  return std::string(kMark) + hash_of_entry(name, bytes) + "\n" + std::string(bytes);
}

std::optional<std::string> unsealed(const std::string& name, std::string entry) {
  if (has_own_hash(name)) {
    if (sha256(entry) != name.substr(name.find('/') + 1)) return std::nullopt;
    return entry;
  }
  const std::size_t begin = kMark.size() + kDigits + 1;
  if (entry.size() < begin || !entry.starts_with(kMark) || entry[begin - 1] != '\n') {
    return std::nullopt;
  }
  const std::string_view all = entry;
  if (hash_of_entry(name, all.substr(begin)) != all.substr(kMark.size(), kDigits)) {
    return std::nullopt;
  }
  entry.erase(0, begin);
  return entry;
}

bool is_of_another_version(std::string_view entry) {
  return entry.starts_with(kAnyMark) && !entry.starts_with(kMark);
}

}  // namespace mjcourse
