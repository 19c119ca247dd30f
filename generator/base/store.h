// Store: bytes that were made once and may be had again, by name.
//
// Two verbs, as in Bazel's HTTP cache, over four kinds of names, each with a SHA-256:
//
//     cas/HASH   the bytes whose hash it is
//     ac/HASH    what was found for the question whose hash it is
//     list/HASH  lists that grow: of two that somebody put, either may be what is there
//     here/HASH  what concerns this machine alone
//
// A caller that asks must be ready to make the bytes anew: a store may lose anything at any time,
// and never gives other bytes than those that were put. With them it gives where they are from
// (origin.h), and a caller that makes something of them says so when that is put. The bytes of a
// hash are the same wherever they are from.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "base/origin.h"

namespace mjcourse {

struct Stored {
  std::string bytes;
  Origin origin = {};
};

class Store {
 public:
  virtual ~Store() = default;

  // All from any thread. `keep` gives false where the bytes could not be kept.
  virtual std::optional<Stored> find(const std::string& name) = 0;
  virtual bool keep(const std::string& name, std::string_view bytes, const Origin& origin) = 0;
  // A list as other machines have it: for a caller whom the list that `find` gives does not help.
  virtual std::optional<Stored> find_of_others(const std::string& /*name*/) { return std::nullopt; }

  // For whom it is all the same where the bytes are from; and for what was made here.
  std::optional<std::string> get(const std::string& name) {
    std::optional<Stored> found = find(name);
    return found ? std::optional(std::move(found->bytes)) : std::nullopt;
  }
  bool put(const std::string& name, std::string_view bytes) { return keep(name, bytes, {}); }
  // How many may ask at once, and each be answered as soon as one alone.
  virtual std::size_t at_once() const { return 1; }
};

}  // namespace mjcourse
