#include "base/blob.h"

#include <optional>
#include <stdexcept>
#include <utility>

#include "base/sha256.h"

namespace mjcourse {

Blob::Blob(std::string bytes) : bytes_(std::move(bytes)) {
  if (!bytes_.empty()) hash_ = sha256(bytes_);
}

Blob Blob::known(std::string hash) {
  Blob blob;
  blob.hash_ = std::move(hash);
  return blob;
}

bool Blob::keep_in(Store& store) {
  if (empty()) return true;
  const std::string name = "cas/" + hash_;
  const bool has = bytes_.empty() ? store.get(name).has_value() : store.put(name, bytes_);
  if (!has) return false;
  bytes_.clear();
  bytes_.shrink_to_fit();
  store_ = &store;
  return true;
}

std::string Blob::bytes() const {
  if (store_ == nullptr) return bytes_;
  std::optional<std::string> bytes = store_->get("cas/" + hash_);
  if (!bytes) throw std::runtime_error("the result store lost " + hash_ + "; run this again");
  return *std::move(bytes);
}

}  // namespace mjcourse
