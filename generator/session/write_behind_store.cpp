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
    const bool kept = slow_->keep(next.name, next.stored.bytes, next.stored.origin);
    lock.lock();
    if (!kept) remember(next.name, next.stored);
    waiting_bytes_ -= next.stored.bytes.size();
    waiting_.pop_front();
    changed_.notify_all();
  }
}

std::optional<Stored> WriteBehindStore::remembered(const std::string& name) const {
  if (const auto known = known_.find(name); known != known_.end()) return known->second;
  const auto newest = std::find_if(waiting_.rbegin(), waiting_.rend(),
                                   [&](const Entry& entry) { return entry.name == name; });
  return newest == waiting_.rend() ? std::nullopt : std::optional(newest->stored);
}

void WriteBehindStore::remember(const std::string& name, Stored stored) {
  if (slow_ != nullptr && known_bytes_ > kMostBytes) {
    known_.clear();
    known_bytes_ = 0;
  }
  known_bytes_ += stored.bytes.size();
  known_[name] = std::move(stored);
}

std::optional<Stored> WriteBehindStore::find(const std::string& name) {
  {
    const std::lock_guard lock(mutex_);
    if (auto found = remembered(name)) return found;
  }
  if (slow_ == nullptr) return std::nullopt;
  std::optional<Stored> stored = slow_->find(name);
  if (stored && is_quick(name)) {
    const std::lock_guard lock(mutex_);
    remember(name, *stored);
  }
  return stored;
}

std::optional<Stored> WriteBehindStore::find_of_others(const std::string& name) {
  return slow_ == nullptr ? std::nullopt : slow_->find_of_others(name);
}

bool WriteBehindStore::keep(const std::string& name, std::string_view bytes, const Origin& origin) {
  std::unique_lock lock(mutex_);
  Stored stored{std::string(bytes), origin};
  if (slow_ == nullptr || is_quick(name)) remember(name, stored);
  if (slow_ == nullptr) return true;
  changed_.wait(lock, [this] { return waiting_bytes_ < kMostBytes; });
  waiting_.push_back({name, std::move(stored)});
  waiting_bytes_ += bytes.size();
  changed_.notify_all();
  return true;
}

}  // namespace mjcourse
