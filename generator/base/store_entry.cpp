#include "base/store_entry.h"

#include <algorithm>
#include <array>

#include "base/sha256.h"

namespace mjcourse {
namespace {

constexpr std::string_view kAnyMark = "mjcourse-store ", kMark = "mjcourse-store 2 ",
                           kStoredMark = "mjcourse-store 3 ";
constexpr std::array<std::string_view, 4> kKinds{"ac/", "cas/", "list/", "here/"};
constexpr std::size_t kDigits = 64;

std::string hash_of_entry(const std::string& name, std::string_view bytes) {
  return Sha256().add(name).add(bytes).hex();
}

std::string hash_of_stored(const std::string& name, std::string_view origin,
                           std::string_view bytes) {
  return Sha256().add(name).add(origin).add(bytes).hex();
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

std::string sealed(const std::string& name, const Stored& stored) {
  if (has_own_hash(name)) return stored.bytes;
  const std::string origin = stored.origin.text();
  return std::string(kStoredMark) + hash_of_stored(name, origin, stored.bytes) + " " + origin +
         "\n" + stored.bytes;
}

std::optional<Stored> unsealed_stored(const std::string& name, std::string entry) {
  if (!entry.starts_with(kStoredMark)) {
    auto bytes = unsealed(name, std::move(entry));
    if (!bytes) return std::nullopt;
    const bool is_ours = has_own_hash(name) || name.starts_with("here/");
    return Stored{*std::move(bytes), is_ours ? Origin() : Origin::unsigned_one()};
  }
  const std::string_view all = entry;
  const std::size_t hash = kStoredMark.size(), word = hash + kDigits + 1;
  const std::size_t end = all.find('\n');
  if (end == all.npos || end < word || all[word - 1] != ' ') return std::nullopt;
  const std::string_view text = all.substr(word, end - word);
  const auto origin = Origin::read(text);
  if (!origin || hash_of_stored(name, text, all.substr(end + 1)) != all.substr(hash, kDigits)) {
    return std::nullopt;
  }
  entry.erase(0, end + 1);
  return Stored{std::move(entry), *origin};
}

bool is_of_another_version(std::string_view entry) {
  return entry.starts_with(kAnyMark) && !entry.starts_with(kMark);
}

bool is_stored_by_another_version(std::string_view entry) {
  return is_of_another_version(entry) && !entry.starts_with(kStoredMark);
}

}  // namespace mjcourse
