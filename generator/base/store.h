// Store: bytes that were made once and may be had again, by name.
//
// Two verbs over two kinds of names, as in Bazel's HTTP cache: `cas/HASH` holds the bytes whose
// SHA-256 is HASH, `ac/HASH` what was found for a question whose SHA-256 is HASH. A caller that
// asks must be ready to make the bytes anew: a store may lose anything at any time, and never gives
// other bytes than those that were put.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace mjcourse {

class Store {
 public:
  virtual ~Store() = default;

  // Both from any thread. `put` gives false where the bytes could not be kept.
  virtual std::optional<std::string> get(const std::string& name) = 0;
  virtual bool put(const std::string& name, std::string_view bytes) = 0;
};

}  // namespace mjcourse
