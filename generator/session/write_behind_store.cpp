#include "session/write_behind_store.h"

#include <algorithm>

namespace mjcourse {
namespace {

// Of a course being written, some megabytes are in use; the rest is of former versions of it.
constexpr std::size_t kMostBytes = 64 << 20;

bool is_quick(const std::string& name) {
  return !name.starts_with("cas/");
}

}  // namespace

WriteBehindStore::WriteBehindStore(Store* slow) : slow_(slow) {
  if (slow_ != nullptr) thread_ = std::jthread([this] { hand_on(); });
}

WriteBehindStore::~WriteBehindStore() {
  const std::lock_guard lock(mutex_);
  stopped_ = true;
  changed_.notify_all();
}

void WriteBehindStore::hand_on() {
  std::unique_lock lock(mutex_);
  for (;;) {
    changed_.wait(lock, [this] { return stopped_ || !waiting_.empty(); });
    if (waiting_.empty()) return;
    const Entry& next = waiting_.front();  // which stays there while others are added
    lock.unlock();
    const bool kept = slow_->put(next.name, next.bytes);
    lock.lock();
    if (!kept) remember(next.name, next.bytes);
    waiting_bytes_ -= next.bytes.size();
    waiting_.pop_front();
    changed_.notify_all();
  }
}

std::optional<std::string> WriteBehindStore::find(const std::string& name) const {
  if (const auto known = known_.find(name); known != known_.end()) return known->second;
  const auto newest = std::find_if(waiting_.rbegin(), waiting_.rend(),
                                   [&](const Entry& entry) { return entry.name == name; });
  return newest == waiting_.rend() ? std::nullopt : std::optional(newest->bytes);
}

void WriteBehindStore::remember(const std::string& name, std::string_view bytes) {
  if (slow_ != nullptr && known_bytes_ > kMostBytes) {
    known_.clear();
    known_bytes_ = 0;
  }
  known_[name] = bytes;
  known_bytes_ += bytes.size();
}

std::optional<std::string> WriteBehindStore::get(const std::string& name) {
  {
    const std::lock_guard lock(mutex_);
    if (auto found = find(name)) return found;
  }
  if (slow_ == nullptr) return std::nullopt;
  std::optional<std::string> bytes = slow_->get(name);
  if (bytes && is_quick(name)) {
    const std::lock_guard lock(mutex_);
    remember(name, *bytes);
  }
  return bytes;
}

std::optional<std::string> WriteBehindStore::get_of_others(const std::string& name) {
  return slow_ == nullptr ? std::nullopt : slow_->get_of_others(name);
}

bool WriteBehindStore::put(const std::string& name, std::string_view bytes) {
  std::unique_lock lock(mutex_);
  if (slow_ == nullptr || is_quick(name)) remember(name, bytes);
  if (slow_ == nullptr) return true;
  changed_.wait(lock, [this] { return waiting_bytes_ < kMostBytes; });
  waiting_.push_back({name, std::string(bytes)});
  waiting_bytes_ += bytes.size();
  changed_.notify_all();
  return true;
}

}  // namespace mjcourse
