// DiskStore: a Store in a folder, shared by all runs of a user.
// store_layout.h says what lies where, and prune_store.h forgets what is old.
//
// An entry is written aside, synced and renamed, so it is there as a whole or not at all; and it is
// verified whenever it is read, since disks and people damage files too. A damaged entry, and
// what else lies in its place, is removed with a note. What is read counts as used, at most once an
// hour.
#pragma once

#include <atomic>
#include <chrono>
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "base/descriptor.h"
#include "base/lock_wait.h"
#include "base/store.h"
#include "base/store_layout.h"

namespace mjcourse {

class DiskStore : public Store {
 public:
  // How long it waits for one who prunes: then it is read alone.
  static constexpr std::chrono::seconds kPatience{10};

  // Makes the folder; where it is there and cannot be written, or somebody keeps it locked, it is
  // read alone. Throws std::system_error where it cannot be used at all. What `trust` does not
  // believe is a miss.
  explicit DiskStore(std::filesystem::path folder, Trust trust = {},
                     const LockWait& wait = {.most = kPatience});
  DiskStore(const DiskStore&) = delete;
  DiskStore& operator=(const DiskStore&) = delete;

  std::optional<Stored> find(const std::string& name) override;
  // After the first entry that cannot be written (a full disk), no more are tried.
  bool keep(const std::string& name, std::string_view bytes, const Origin& origin) override;

  const std::filesystem::path& folder() const { return folder_; }
  bool can_be_written() const { return writable_; }
  // Sentences for the user: of a damaged entry, of a full disk, of an entry that nobody who is
  // trusted has signed.
  std::vector<std::string> notes() const;

 private:
  void prepare();
  void lock(const LockWait& wait);
  std::error_code clear(const StorePlace& place) const;
  void make_letters(const StorePlace& place) const;
  void write(const StorePlace& place, std::string_view bytes) const;
  void note(std::string_view text);
  void note_doubt(const std::string& name);

  std::filesystem::path folder_;
  Trust trust_;
  std::atomic<bool> doubted_ = false;  // and said so
  std::atomic<bool> blocked_ = false;  // an entry's place, and said so
  Descriptor lock_;
  std::atomic<bool> writable_ = true;
  mutable std::mutex mutex_;  // of the notes
  std::vector<std::string> notes_;
};

}  // namespace mjcourse
