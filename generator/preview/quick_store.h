// QuickStore: a store that remembers what it was asked for, before one on the disk.
//
// Whoever looks for the same results many times a minute has no need to read and verify their files
// each time. Blobs, which are large and seldom looked at, stay where they are.
#pragma once

#include <map>
#include <mutex>
#include <optional>
#include <string>

#include "base/store.h"

namespace mjcourse {

class QuickStore : public Store {
 public:
  // `slow` must outlive this; it may be null, and then what is put lives as long as this.
  explicit QuickStore(Store* slow) : slow_(slow) {}

  std::optional<std::string> get(const std::string& name) override;
  bool put(const std::string& name, std::string_view bytes) override;

 private:
  Store* slow_;
  std::mutex mutex_;
  std::map<std::string, std::string> known_;
  std::size_t bytes_ = 0;
};

}  // namespace mjcourse
