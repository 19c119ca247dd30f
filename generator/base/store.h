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
// and never gives other bytes than those that were put.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace mjcourse {

class Store {
 public:
  virtual ~Store() = default;

  // All from any thread. `put` gives false where the bytes could not be kept.
  virtual std::optional<std::string> get(const std::string& name) = 0;
  virtual bool put(const std::string& name, std::string_view bytes) = 0;
  // A list as other machines have it: for a caller whom the list that `get` gives does not help.
  virtual std::optional<std::string> get_of_others(const std::string& /*name*/) {
    return std::nullopt;
  }
  // How many may ask at once, and each be answered as soon as one alone.
  virtual std::size_t at_once() const { return 1; }
};

}  // namespace mjcourse
