// WriteBehindStore: a store that remembers what it was asked for, before one on the disk.
//
// A caller that looks for the same results many times a minute need not read and verify their files
// each time, nor to wait until a disk has what was put. Blobs, which are large and seldom looked
// at, stay there.
#pragma once

#include <condition_variable>
#include <deque>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "base/store.h"

namespace mjcourse {

class WriteBehindStore : public Store {
 public:
  // `slow` must outlive this; it may be null, and then what is put lives as long as this.
  explicit WriteBehindStore(Store* slow);
  // Waits until the other store has all that was put.
  ~WriteBehindStore() override;
  WriteBehindStore(const WriteBehindStore&) = delete;
  WriteBehindStore& operator=(const WriteBehindStore&) = delete;

  std::optional<Stored> find(const std::string& name) override;
  bool keep(const std::string& name, std::string_view bytes, const Origin& origin) override;
  std::optional<Stored> find_of_others(const std::string& name) override;
  std::size_t at_once() const override { return slow_ == nullptr ? 1 : slow_->at_once(); }

 private:
  struct Entry {
    std::string name;
    Stored stored;
  };

  void hand_on();
  std::optional<Stored> remembered(const std::string& name) const;
  void remember(const std::string& name, Stored stored);

  Store* slow_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::map<std::string, Stored> known_;
  std::deque<Entry> waiting_;  // for the other store, in the order in which they came
  std::size_t known_bytes_ = 0, waiting_bytes_ = 0;
  bool stopped_ = false;
  std::jthread thread_;  // last: it uses the rest
};

}  // namespace mjcourse
