#include "remote/shared_store.h"

#include <utility>

namespace mjcourse {
namespace {

constexpr int kSenders = 8;
constexpr std::size_t kAskers = 32;

// What is no other machine's business.
bool stays_here(const std::string& name) {
  return name.starts_with("here/");
}

bool is_list(const std::string& name) {
  return name.starts_with("list/");
}

}  // namespace

SharedStore::SharedStore(Store& disk, Store& remote, Sends sends)
    : disk_(disk), remote_(remote), sends_(sends) {
  for (int i = 0; sends != Sends::nothing && i < kSenders; ++i) {
    senders_.emplace_back([this] { send(); });
  }
}

SharedStore::~SharedStore() {
  const std::lock_guard lock(mutex_);
  stopped_ = true;
  changed_.notify_all();
}

void SharedStore::wait() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return waiting_.empty() && sending_ == 0; });
}

void SharedStore::send() {
  std::unique_lock lock(mutex_);
  for (;;) {
    changed_.wait(lock, [this] { return stopped_ || !waiting_.empty(); });
    if (waiting_.empty()) return;
    Entry next = std::move(waiting_.front());
    waiting_.pop_front();
    ++sending_;
    lock.unlock();
    // A list may have grown since.
    if (!next.stored) next.stored = disk_.find(next.name);
    if (next.stored) remote_.keep(next.name, next.stored->bytes, next.stored->origin);
    lock.lock();
    --sending_;
    if (waiting_.empty() && sending_ == 0) changed_.notify_all();
  }
}

std::optional<Stored> SharedStore::find(const std::string& name) {
  if (auto stored = disk_.find(name)) {
    // Lists are put by those who join them with what is there.
    const bool is_sent = sends_ == Sends::all && !is_list(name) && stored->origin.is_made_here();
    if (is_sent) send_later(name, std::nullopt);
    return stored;
  }
  if (stays_here(name) || sends_ == Sends::all) return std::nullopt;
  std::optional<Stored> stored = remote_.find(name);
  if (!stored) return std::nullopt;
  disk_.keep(name, stored->bytes, stored->origin);
  const std::lock_guard lock(mutex_);
  received_.insert(name);
  return stored;
}

bool SharedStore::came_from_there(const std::string& name) const {
  const std::lock_guard lock(mutex_);
  return received_.contains(name);
}

std::optional<Stored> SharedStore::find_of_others(const std::string& name) {
  return remote_.find(name);
}

// What a thread of ours waits for is a way, and not work.
std::size_t SharedStore::at_once() const {
  return kAskers;
}

bool SharedStore::keep(const std::string& name, std::string_view bytes, const Origin& origin) {
  const bool kept = disk_.keep(name, bytes, origin);
  send_later(name, kept ? std::nullopt : std::optional(Stored{std::string(bytes), origin}));
  return kept;
}

void SharedStore::send_later(const std::string& name, std::optional<Stored> stored) {
  if (stays_here(name) || sends_ == Sends::nothing) return;
  const std::lock_guard lock(mutex_);
  // A name that is not a list's has the same bytes each time.
  if (!is_list(name) && !sent_.insert(name).second) return;
  waiting_.push_back({name, std::move(stored)});
  changed_.notify_one();
}

}  // namespace mjcourse
