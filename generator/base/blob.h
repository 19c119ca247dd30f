// Blob: bytes that may be many, known by their hash.
//
// Those that a store keeps are not held in memory, but read again when they are asked for; so a
// course may have any number of pictures.
#pragma once

#include <memory>
#include <string>

#include "base/store.h"

namespace mjcourse {

class Blob {
 public:
  Blob() = default;
  explicit Blob(std::string bytes);
  // The bytes with this hash, which `keep_in` is to find.
  static Blob known(std::string hash);

  bool empty() const { return hash_.empty(); }
  const std::string& hash() const { return hash_; }  // SHA-256; empty for no bytes

  // From here on the bytes are `store`'s, which must outlive this; those that are here are put
  // there first. False where the store does not have them.
  bool keep_in(Store& store);

  // Throws std::runtime_error when the store has lost them since.
  std::string bytes() const;

 private:
  std::string hash_, bytes_;
  Store* store_ = nullptr;
};

}  // namespace mjcourse
