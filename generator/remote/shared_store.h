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
  // To the remote store: nothing; what is put; or also all that the disk is asked for, has, and was
  // made here, and then nothing else is taken from there but lists.
  enum class Sends { nothing, puts, all };

  // Both must outlive this.
  SharedStore(Store& disk, Store& remote, Sends sends);
  ~SharedStore() override;  // waits
  SharedStore(const SharedStore&) = delete;
  SharedStore& operator=(const SharedStore&) = delete;

  std::optional<Stored> find(const std::string& name) override;
  bool keep(const std::string& name, std::string_view bytes, const Origin& origin) override;
  std::optional<Stored> find_of_others(const std::string& name) override;
  std::size_t at_once() const override;

  // Returns once the remote store has all, or does not take any more.
  void wait();

  // Did the remote store give it, and the disk not have it?
  bool came_from_there(const std::string& name) const;

 private:
  struct Entry {
    std::string name;
    std::optional<Stored> stored;  // where the disk does not have it
  };

  void send();
  void send_later(const std::string& name, std::optional<Stored> stored);

  Store& disk_;
  Store& remote_;
  const Sends sends_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Entry> waiting_;  // to be sent, in the order in which they came
  std::set<std::string> sent_, received_;
  std::size_t sending_ = 0;  // threads that are
  bool stopped_ = false;
  std::vector<std::jthread> senders_;  // last: they use the rest
};

}  // namespace mjcourse
