// A store that lives as long as the process, for tests.
#pragma once

#include <map>
#include <mutex>

#include "base/store.h"

namespace mjcourse {

class MemoryStore : public Store {
 public:
  std::optional<Stored> find(const std::string& name) override {
    const std::lock_guard lock(mutex_);
    const auto found = kept_.find(name);
    return found == kept_.end() ? std::nullopt : std::optional(found->second);
  }
  bool keep(const std::string& name, std::string_view bytes, const Origin& origin) override {
    const std::lock_guard lock(mutex_);
    kept_[name] = {std::string(bytes), origin};
    return true;
  }

 private:
  std::mutex mutex_;
  std::map<std::string, Stored> kept_;
};

}  // namespace mjcourse
