// SharedStore: a store on this machine's disk, before one that many machines share.
//
// What the disk does not have is asked for there, and then on the disk too. What is put is on the
// disk at once, and there a little later: threads of its own send it, and the end waits for them.
// Tested by tests/generator/remote/shared_store_test.cpp.
#pragma once

#include <condition_variable>
#include <deque>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "base/store.h"

namespace mjcourse {

class SharedStore : public Store {
 public:
  // Both must outlive this. `written`: what is put goes to both.
  SharedStore(Store& disk, Store& remote, bool written);
  // Waits until the remote store has all, or does not take any more.
  ~SharedStore() override;
  SharedStore(const SharedStore&) = delete;
  SharedStore& operator=(const SharedStore&) = delete;

  std::optional<std::string> get(const std::string& name) override;
  bool put(const std::string& name, std::string_view bytes) override;
  std::optional<std::string> get_of_others(const std::string& name) override;
  std::size_t at_once() const override;

 private:
  struct Entry {
    std::string name;
    std::optional<std::string> bytes;  // where the disk does not have them
  };

  void send();

  Store& disk_;
  Store& remote_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Entry> waiting_;  // to be sent, in the order in which they came
  std::set<std::string> sent_;
  bool stopped_ = false;
  std::vector<std::jthread> senders_;  // last: they use the rest
};

}  // namespace mjcourse
